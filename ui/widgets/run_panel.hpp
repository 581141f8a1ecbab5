#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QWidget>

#include "widgets/parts.hpp"
#include "widgets/workspace.hpp"

namespace talus {

/// How the run goes: share done, time left, contacts, penetration, blocks asleep; what each effect costs and why it is
/// on.
class RunPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunPanel(Workspace& workspace);

 private:
  void refresh();
  QLabel* addFact(QGridLayout& grid, const QString& name);

  Workspace& workspace_;
  PanelHeader* header_;
  QLabel *percent_, *left_, *spent_;
  QProgressBar* bar_;
  QLabel *time_, *step_, *contacts_, *penetration_, *iterations_, *asleep_;
};

}  // namespace talus
