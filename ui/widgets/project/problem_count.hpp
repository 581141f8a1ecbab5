#pragma once

#include <QToolButton>

namespace talus {

class CurrentProject;
class Messages;

/// In the status bar: how many errors, warnings and hints there are. A click shows them.
class ProblemCount : public QToolButton {
  Q_OBJECT
 public:
  ProblemCount(CurrentProject& project, Messages& messages);

 private:
  void refresh();
  CurrentProject& project_;
  Messages& messages_;
};

}  // namespace talus
