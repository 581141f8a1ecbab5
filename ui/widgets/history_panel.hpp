#pragma once

#include <QWidget>

#include "widgets/parts.hpp"
#include "widgets/plot.hpp"
#include "widgets/workspace.hpp"

namespace talus {

/// Histories over time, live and from results: monitors' displacement and speed, energies, and how hard the solver
/// works. A click or drag in one goes to that moment.
class HistoryPanel : public QWidget {
  Q_OBJECT
 public:
  explicit HistoryPanel(Workspace& workspace);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  void showPlotsOfStep();
  void fillMonitors();
  void fillSolver();
  void fillEnergy();
  std::vector<double> stepTimes() const;

  Workspace& workspace_;
  Plot *displacement_, *speed_, *energy_, *iterations_, *contacts_;
  QWidget* empty_;
};

}  // namespace talus
