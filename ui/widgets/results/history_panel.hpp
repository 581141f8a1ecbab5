#pragma once

#include <QWidget>

#include "widgets/kit/parts.hpp"
#include "widgets/kit/plot.hpp"

namespace talus {

class CurrentRun;
class Display;
class Playback;

/// Histories over time, live and from results: monitors' displacement and speed, energies, and how hard the solver
/// works. A click or drag in one goes to that moment.
class HistoryPanel : public QWidget {
  Q_OBJECT
 public:
  HistoryPanel(CurrentRun& run, Playback& playback, Display& display);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  void showPlotsOfPage();
  void fillMonitors();
  void fillSolver();
  void fillEnergy();
  std::vector<double> stepTimes() const;

  CurrentRun& run_;
  Playback& playback_;
  Display& display_;
  Plot *displacement_, *speed_, *energy_, *iterations_, *contacts_;
  QWidget* empty_;
};

}  // namespace talus
