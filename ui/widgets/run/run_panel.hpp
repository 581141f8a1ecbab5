#pragma once

#include <QWidget>

#include "widgets/kit/parts.hpp"

class QProgressBar;
class QPushButton;

namespace talus {

class CurrentProject;
class CurrentRun;
class Display;
class ProjectStudy;

/// What a run will cost, before it; then how it goes: share done, time left, contacts, penetration, blocks asleep;
/// where it has trouble to converge; what each effect costs and why it is on.
class RunPanel : public QWidget {
  Q_OBJECT
 public:
  RunPanel(CurrentProject& project, CurrentRun& run, ProjectStudy& study, Display& display);

 private:
  void refresh();

  CurrentProject& project_;
  CurrentRun& run_;
  PanelHeader* header_;
  QLabel *percent_, *left_, *spent_;
  QProgressBar* bar_;
  QPushButton* goOn_;
};

}  // namespace talus
