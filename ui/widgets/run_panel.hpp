#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QWidget>

#include "widgets/parts.hpp"
#include "widgets/workspace.hpp"

namespace talus {

/// What a run will cost, before it; then how it goes: share done, time left, contacts, penetration, blocks asleep;
/// where it struggles; what each effect costs and why it is on.
class RunPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunPanel(Workspace& workspace);

 private:
  void refresh();

  Workspace& workspace_;
  PanelHeader* header_;
  QLabel *percent_, *left_, *spent_;
  QProgressBar* bar_;
};

}  // namespace talus
