#include "widgets/run/step_facts.hpp"

#include <QGridLayout>
#include <QLabel>

#include <algorithm>

#include "mesh/mesh_size.hpp"
#include "results/energy_moved.hpp"
#include "session/current_project.hpp"
#include "session/current_run.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

namespace {

const QString not_told = QStringLiteral("–");
constexpr std::size_t recent = 20;  // steps that the pace is the mean of

QString percent(double share) { return numbers::significant(100 * share, 2); }

double secondsOf(const Phases& p) { return p.detect + p.assemble + p.factor + p.solve + p.update + p.write; }

/// Mean wall time of the last steps, s.
double pace(const std::vector<StepReport>& steps) {
  const std::size_t count = std::min(recent, steps.size());
  double seconds = 0;
  for (std::size_t i = steps.size() - count; i < steps.size(); ++i) seconds += secondsOf(steps[i].phases);
  return seconds / static_cast<double>(count);
}

}  // namespace

StepFacts::StepFacts(CurrentProject& project, CurrentRun& run)
    : project_(project), run_(run), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 4, 0, 4);
  grid_->setVerticalSpacing(3);
  grid_->setHorizontalSpacing(12);
  grid_->setColumnStretch(1, 1);
  underWay_ =
      add(tr("Under way"), tr("The step that is being made: its open–close iterations so far, and the norm of the "
                              "force that is out of balance"));
  time_ = add(tr("t"), tr("Model time"));
  step_ = add(tr("Step"), tr("Its number and length"));
  pace_ = add(tr("Pace"), tr("Wall time of a step, mean of the last %1").arg(recent));
  iterations_ = add(tr("Iterations"), tr("Open–close iterations of the step"));
  asleep_ = add(tr("Asleep"), tr("Blocks at rest that are not computed"));
  contacts_ = add(tr("Contacts"), tr("Contact points of blocks that are awake, by state"));
  penetration_ = add(tr("Penetration"), tr("Deepest of the step, over the local mesh size"));
  unbalanced_ = add(tr("Unbalanced"), tr("Norm of the force that is left out of balance at the end of the step"));
  error_ = add(tr("Time error"), tr("Estimated error of time integration in this step, over the smallest mesh size"));
  remainder_ = add(tr("Remainder"), tr("Energy that the ledger misses, over the energy that has moved in the run"));
  damped_ =
      add(tr("Numerical damping"), tr("Energy that time integration has dissipated, over the energy that has moved"));
  connect(&run_, &CurrentRun::historyChanged, this, &StepFacts::refresh);
  connect(&run_, &CurrentRun::progressed, this, &StepFacts::refresh);
  connect(&project_, &CurrentProject::systemChanged, this, [this] {
    size_ = project_.system() ? smallest_mesh_size(*project_.system()) : 0;
    refresh();
  });
  refresh();
}

QLabel* StepFacts::add(const QString& name, const QString& tip) {
  const int row = grid_->rowCount();
  auto* label = makeLabel(name, "small");
  label->setToolTip(tip);
  grid_->addWidget(label, row, 0, Qt::AlignTop);
  auto* value = makeWrappedLabel(not_told);
  value->setAccessibleName(name);
  grid_->addWidget(value, row, 1);
  values_.push_back(value);
  return value;
}

void StepFacts::followEnergy() {
  const auto& steps = run_.steps();
  if (looked_ > steps.size()) looked_ = 0;  // another run
  if (looked_ == 0) moved_ = 0;
  for (; looked_ < steps.size(); ++looked_) moved_ = std::max(moved_, largest_account(steps[looked_].energy));
}

void StepFacts::refresh() {
  followEnergy();
  const bool isUnderWay = run_.iterations() > 0;
  setVisible(isUnderWay || !run_.steps().empty());
  if (run_.steps().empty())
    for (auto* label : values_) label->setText(not_told);
  underWay_->setText(
      isUnderWay
          ? tr("iteration %1, %2 kN").arg(run_.iterations()).arg(numbers::significant(run_.unbalanced() / 1e3, 2))
          : not_told);
  if (run_.steps().empty()) return;
  const StepReport& step = run_.steps().back();
  time_->setText(tr("%1 s").arg(numbers::fixed(step.time, 2)));
  step_->setText(step.time_step > 0
                     ? tr("%1, Δt %2 ms").arg(numbers::whole(step.step), numbers::significant(step.time_step * 1e3))
                     : tr("%1, not converged").arg(numbers::whole(step.step)));
  pace_->setText(tr("%1 ms a step").arg(numbers::significant(pace(run_.steps()) * 1e3, 2)));
  iterations_->setText(step.cuts > 0
                           ? tr("%1, step cut %2").arg(step.iterations).arg(numbers::counted(step.cuts, "time"))
                           : numbers::whole(step.iterations));
  asleep_->setText(step.asleep > 0 ? numbers::counted(step.asleep, "block") : tr("no block"));
  contacts_->setText(tr("%1 open, %2 stick, %3 slip")
                         .arg(numbers::whole(step.open), numbers::whole(step.stick), numbers::whole(step.slip)));
  penetration_->setText(tr("%1 % of mesh size").arg(percent(step.max_relative_penetration)));
  unbalanced_->setText(tr("%1 kN").arg(numbers::significant(step.unbalanced_force / 1e3, 2)));
  error_->setText(size_ > 0 ? tr("%1 % of mesh size").arg(percent(step.time_error / size_)) : not_told);
  remainder_->setText(moved_ > 0 ? tr("%1 % of energy").arg(percent(std::abs(step.energy.remainder) / moved_))
                                 : not_told);
  damped_->setText(moved_ > 0 ? tr("%1 % of energy").arg(percent(step.energy.integration_loss / moved_)) : not_told);
}

}  // namespace talus
