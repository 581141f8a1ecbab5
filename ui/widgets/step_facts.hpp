#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QWidget>

#include "widgets/workspace.hpp"

namespace talus {

/// The last step of the run: where it is, what it cost, and how good it is.
class StepFacts : public QWidget {
  Q_OBJECT
 public:
  explicit StepFacts(Workspace& workspace);

 private:
  QLabel* add(const QString& name, const QString& tip);
  void refresh();
  void followEnergy();

  Workspace& workspace_;
  QGridLayout* grid_;
  std::vector<QLabel*> values_;
  QLabel *time_, *step_, *pace_, *iterations_, *asleep_, *contacts_, *penetration_, *unbalanced_, *error_, *remainder_,
      *eaten_;
  double size_ = 0;         ///< m, smallest mesh size of the blocks that move
  double moved_ = 0;        ///< J, energy that moved in the steps that were looked at
  std::size_t looked_ = 0;  ///< steps
};

}  // namespace talus
