#pragma once

#include <QWidget>

class QGridLayout;
class QLabel;

namespace talus {

class CurrentProject;
class CurrentRun;

/// The last step of the run: where it is, what it cost, and how good it is.
class StepFacts : public QWidget {
  Q_OBJECT
 public:
  StepFacts(CurrentProject& project, CurrentRun& run);

 private:
  QLabel* add(const QString& name, const QString& tip);
  void refresh();
  void followEnergy();

  CurrentProject& project_;
  CurrentRun& run_;
  QGridLayout* grid_;
  std::vector<QLabel*> values_;
  QLabel *underWay_, *time_, *step_, *pace_, *iterations_, *asleep_, *contacts_, *penetration_, *unbalanced_, *error_,
      *remainder_, *damped_;
  double size_ = 0;         ///< m, smallest mesh size of the blocks that move
  double moved_ = 0;        ///< J, energy that moved in the steps that were looked at
  std::size_t looked_ = 0;  ///< steps
};

}  // namespace talus
