#pragma once

#include <QWidget>

#include "session/messages.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

class ProjectProblems;
class Display;

/// What stands beside several problems: the icon of the worst of them.
QIcon iconOfProblems(Problem::Severity worst);

/// One problem: what, where, remedy; Enter, a double click or its button go there.
class ProblemRow : public QFrame {
  Q_OBJECT
 public:
  ProblemRow(const Problem& problem, Display& display);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void go();
  Problem problem_;
  Display& display_;
  bool leads_;  ///< somewhere
};

/// What went wrong since the project was opened, and all that is wrong or odd with the project as it is.
class ProblemList : public QWidget {
  Q_OBJECT
 public:
  ProblemList(const ProjectProblems& problems, Messages& messages, Display& display);

 private:
  void refresh();
  const ProjectProblems& problems_;
  Messages& messages_;
  Display& display_;
  QVBoxLayout* rows_;
};

/// The newest problem across the top of the view, until it is closed or another file is opened.
class ProblemStrip : public QFrame {
  Q_OBJECT
 public:
  ProblemStrip(Messages& messages, Display& display);

 private:
  void show(const Problem& problem);
  Glyph* glyph_;
  QLabel *what_, *remedy_;
  QPushButton* show_;
  std::optional<ConvergenceTrouble> where_;  ///< of the problem that is shown
  int number_ = 0;                           ///< its own
};

}  // namespace talus
