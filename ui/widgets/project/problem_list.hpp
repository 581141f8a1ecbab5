#pragma once

#include <QWidget>

#include "session/messages.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

class Display;

/// Every problem since the project was opened: what, where, remedy.
class ProblemList : public QWidget {
  Q_OBJECT
 public:
  ProblemList(Messages& messages, Display& display);

 private:
  void refresh();
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
