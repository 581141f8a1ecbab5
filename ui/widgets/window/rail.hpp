#pragma once

#include <QFrame>
#include <map>

#include "session/workflow_page.hpp"

namespace talus {

struct Session;

class RailItem;

/// The workflow down the left edge: each page with its state as a badge. Going back is always free.
class Rail : public QFrame {
  Q_OBJECT
 public:
  explicit Rail(Session& session);

 private:
  void refresh();
  /// The first of what keeps the project from being solved that is set right on this page; empty: nothing there does.
  QString errorOn(WorkflowPage page) const;

  Session& session_;
  std::map<WorkflowPage, RailItem*> items_;
};

/// One page: icon, word, badge.
class RailItem : public QWidget {
  Q_OBJECT
 public:
  enum class State { open, done, doubtful, busy, locked };
  explicit RailItem(WorkflowPage page);
  void setState(State state, const QString& why);
  void setCurrent(bool current);
  State state() const { return state_; }

 signals:
  void chosen();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  WorkflowPage page_;
  State state_ = State::open;
  bool current_ = false;
};

}  // namespace talus
