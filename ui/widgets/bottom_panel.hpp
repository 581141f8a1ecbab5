#pragma once

#include <QPlainTextEdit>
#include <QTabWidget>

#include "widgets/workspace.hpp"

namespace talus {

/// Under the view: the step's table, histories, problems, log. The tab that a step needs comes to the front with it.
class BottomPanel : public QTabWidget {
  Q_OBJECT
 public:
  explicit BottomPanel(Workspace& workspace);

 private:
  void showStep();
  void countProblems();
  Workspace& workspace_;
  QWidget *table_, *histories_, *problems_;
  QPlainTextEdit* log_;
};

}  // namespace talus
