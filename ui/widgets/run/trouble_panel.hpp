#pragma once

#include <QWidget>
#include <vector>

#include "results/convergence_trouble.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

class CurrentRun;
class Display;

class TroubleRow;

/// Where the run has trouble to converge, place by place: blocks, joint, what it took, what to change, and a button
/// that turns the view there. Takes no room while there is nothing to say.
class TroublePanel : public QWidget {
  Q_OBJECT
 public:
  TroublePanel(CurrentRun& run, Display& display);

 private:
  void refresh();
  CurrentRun& run_;
  Display& display_;
  QLabel* heading_;
  QVBoxLayout* column_;
  std::vector<TroubleRow*> rows_;  ///< kept: a button must not go from under the hand that clicks it
};

/// One of its places.
class TroubleRow : public QWidget {
  Q_OBJECT
 public:
  TroubleRow();
  void show(const ConvergenceTrouble& trouble);

 signals:
  void wanted(const talus::ConvergenceTrouble& trouble);

 private:
  ConvergenceTrouble trouble_;
  ElidedLabel* contact_;
  QLabel *cost_, *advice_;
};

}  // namespace talus
