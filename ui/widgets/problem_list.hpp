#pragma once

#include <QVBoxLayout>
#include <QWidget>

#include "widgets/parts.hpp"
#include "widgets/workspace.hpp"

namespace talus {

/// Every problem since the project was opened: what, where, remedy.
class ProblemList : public QWidget {
  Q_OBJECT
 public:
  explicit ProblemList(Workspace& workspace);

 private:
  void refresh();
  Workspace& workspace_;
  QVBoxLayout* rows_;
};

/// The newest problem across the top of the view, until it is closed or another file is opened.
class ProblemStrip : public QFrame {
  Q_OBJECT
 public:
  explicit ProblemStrip(Workspace& workspace);

 private:
  void show(const Problem& problem);
  Glyph* glyph_;
  QLabel *what_, *remedy_;
  QPushButton* show_;
  std::optional<Struggle> where_;  ///< of the problem that is shown
};

}  // namespace talus
