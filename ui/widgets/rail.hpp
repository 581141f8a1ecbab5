#pragma once

#include <QFrame>
#include <map>

#include "widgets/workspace.hpp"

namespace talus {

class RailStep;

/// The workflow down the left edge: each step with its state as a badge. Going back is always free.
class Rail : public QFrame {
  Q_OBJECT
 public:
  explicit Rail(Workspace& workspace);

 private:
  void refresh();
  Workspace& workspace_;
  std::map<Step, RailStep*> steps_;
};

/// One step: icon, word, badge.
class RailStep : public QWidget {
  Q_OBJECT
 public:
  enum class State { open, done, busy, locked };
  explicit RailStep(Step step);
  void setState(State state, const QString& why);
  void setCurrent(bool current);

 signals:
  void chosen();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  Step step_;
  State state_ = State::open;
  bool current_ = false;
};

}  // namespace talus
