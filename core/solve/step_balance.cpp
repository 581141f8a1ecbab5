#include "solve/step_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "solve/stopwatch.hpp"

namespace talus {

namespace {

/// Internal forces of stressed rock cancel in equilibrium: round-off in them must not count as imbalance, nor may their
/// size hide one.
constexpr double internal_share = 1e-3;
/// The same for the change of momentum that a free flight would need.
constexpr double momentum_share = 1e-6;

/// While it lives, moments are taken with the arms that there are at the end of the step, as those of a potential are.
class EndArms {
 public:
  explicit EndArms(BodySet& set) : set_(set), before_(std::exchange(set.mean_arms, false)) {}
  ~EndArms() { set_.mean_arms = before_; }
  EndArms(const EndArms&) = delete;
  EndArms& operator=(const EndArms&) = delete;

 private:
  BodySet& set_;
  bool before_;
};

}  // namespace

std::map<std::string, StepBalance::EffectWork> StepBalance::effect_work() const {
  std::map<std::string, EffectWork> all = earlier_work_;
  for (std::size_t i = 0; i < effect_work_.size(); ++i) {
    EffectWork& sum = all[std::string(composition_->effects[i]->name())];
    sum.seconds += effect_work_[i].seconds;
    sum.built += effect_work_[i].built;
    sum.evaluations += effect_work_[i].evaluations;
    sum.assemblies += effect_work_[i].assemblies;
  }
  return all;
}

void StepBalance::end_stage() {
  earlier_work_ = effect_work();
  effect_work_.clear();
}

void StepBalance::begin_stage(Composition& composition) {
  composition_ = &composition;
  effect_work_.assign(composition.effects.size(), {.built = 1});
  works_.assign(composition.effects.size(), 0);
  norms_.assign(composition.effects.size(), 0);
  step_.length = 0;
}

void StepBalance::set_pattern(int nodes, std::vector<std::pair<int, int>> couplings) {
  for (const auto& effect : composition_->effects) effect->add_couplings(couplings);
  const BlockPattern pattern(nodes, std::move(couplings));
  constant_.set_pattern(pattern);
  of_step_.set_pattern(pattern);
  matrix_.set_pattern(pattern);
  zero_.setZero(3 * nodes);
  pattern_changed_ = true;
  rounding_ = rounding_of_positions_ = 0;
}

void StepBalance::assemble_constant() {
  pattern_changed_ = false;
  constant_.set_zero();
  for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
    const Effect& effect = *composition_->effects[i];
    if (!effect.constant()) continue;
    const Stopwatch share(effect_work_[i].seconds);
    constant_.set_weight(effect.smooth() ? share_ : 1);
    effect.add_hessian(zero_, constant_);
    ++effect_work_[i].assemblies;
  }
}

bool StepBalance::begin_step(const StepContext& step) {
  const Stopwatch watch(times_.assemble);
  const bool same_kind = step.length == step_.length && step.integration == step_.integration;
  step_ = step;
  share_ = step.integration.smooth_share();
  if (!same_kind || pattern_changed_) assemble_constant();
  of_step_.assign(constant_);
  part_.resize(zero_.size());
  momentum_scale_ = 0;
  for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
    const Effect& effect = *composition_->effects[i];
    const Stopwatch share(effect_work_[i].seconds);
    of_step_.set_weight(effect.smooth() ? share_ : 1);
    if (effect.quadratic() && !effect.constant()) {
      effect.add_hessian(zero_, of_step_);
      ++effect_work_[i].assemblies;
    }
    if (effect.account() != EnergyAccount::kinetic) continue;
    part_.setZero();
    effect.add_gradient(zero_, part_);
    momentum_scale_ = momentum_share * part_.norm();
  }
  return !same_kind;
}

void StepBalance::evaluate(const Increment& d, Friction friction) {
  const Stopwatch watch(times_.update);
  if (composition_->shear && friction == Friction::coupled) composition_->shear->update_strength(d);
  std::optional<EndArms> with_potential;
  if (friction == Friction::lagged) with_potential.emplace(*composition_->bodies);
  if (friction == Friction::lagged)
    gradient_ = held_;
  else
    gradient_.setZero(d.size());
  part_.resize(d.size());
  scaled_ = share_ * d;
  force_scale_ = momentum_scale_;
  for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
    const Effect& effect = *composition_->effects[i];
    const Stopwatch share(effect_work_[i].seconds);
    part_.setZero();
    effect.add_gradient(effect.smooth() ? scaled_ : d, part_);
    ++effect_work_[i].evaluations;
    gradient_ += part_;
    works_[i] = part_.dot(d);
    norms_[i] = part_.norm();
    const double counts = effect.account() == EnergyAccount::elastic ? internal_share : 1;
    force_scale_ = std::max(force_scale_, counts * norms_[i]);
  }
}

void StepBalance::hold(const Increment& d) {
  held_.setZero(d.size());
  if (!composition_->bodies->mean_arms) return;
  held_ = -gradient_;
  evaluate(d, Friction::lagged);  // what has a potential, less what there is
  held_.swap(gradient_);
  held_ *= -1;
  gradient_ *= -1;
}

void StepBalance::evaluate_without_inertia() {
  evaluate(zero_, Friction::coupled);
  for (const auto& effect : composition_->effects) {
    if (effect->account() != EnergyAccount::kinetic) continue;
    part_.setZero();
    effect->add_gradient(zero_, part_);
    gradient_ -= part_;
  }
}

double StepBalance::imbalance() const {
  double inertia = 0, largest = 0;
  for (std::size_t i = 0; i < norms_.size(); ++i) {
    const bool kinetic = composition_->effects[i]->account() == EnergyAccount::kinetic;
    double& norm = kinetic ? inertia : largest;
    norm = std::max(norm, norms_[i]);
  }
  return largest > 0 ? inertia / largest : 0;
}

void StepBalance::assemble(const Increment& d, double touching) {
  const Stopwatch watch(times_.assemble);
  for (NormalContact* normal : composition_->normal) normal->count_as_closed(touching);
  if (composition_->shear) composition_->shear->count_as_closed(touching);
  matrix_.assign(of_step_);
  add_hessians(d, Contacts::included, matrix_);
}

void StepBalance::add_hessians(const Increment& d, Contacts contacts, SymmetricBlocks& matrix) {
  scaled_ = share_ * d;
  for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
    const Effect& effect = *composition_->effects[i];
    if (effect.quadratic() || (contacts == Contacts::left_out && effect.account() == EnergyAccount::contact)) continue;
    const Stopwatch share(effect_work_[i].seconds);
    matrix.set_weight(effect.smooth() ? share_ : 1);
    effect.add_hessian(effect.smooth() ? scaled_ : d, matrix);
    ++effect_work_[i].assemblies;
  }
  matrix.set_weight(1);
}

void StepBalance::add_unsymmetric(const Increment& d, Contacts contacts, UnsymmetricBlocks& beyond) const {
  for (const auto& effect : composition_->effects)
    if (contacts == Contacts::included || effect->account() != EnergyAccount::contact)
      effect->add_unsymmetric(d, beyond);
}

void StepBalance::add_beyond(const Increment& d, UnsymmetricBlocks& beyond) {
  const Stopwatch watch(times_.assemble);
  add_unsymmetric(d, Contacts::included, beyond);
}

void StepBalance::measure_rounding() {
  const double stiffness = matrix_.diagonal_norm();
  rounding_ = std::numeric_limits<double>::epsilon() * step_.mesh_size * stiffness;
  rounding_of_positions_ = std::numeric_limits<double>::epsilon() * step_.extent * stiffness;
}

void StepBalance::add_gradient_of_rest(const Increment& d, Eigen::VectorXd& sum) {
  scaled_ = share_ * d;
  for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
    const Effect& effect = *composition_->effects[i];
    if (effect.account() == EnergyAccount::contact) continue;
    const Stopwatch seconds(effect_work_[i].seconds);
    effect.add_gradient(effect.smooth() ? scaled_ : d, sum);
    ++effect_work_[i].evaluations;
  }
}

void StepBalance::assemble_rest(const Increment& d, SymmetricBlocks& matrix, UnsymmetricBlocks& beyond) {
  matrix.assign(of_step_);
  add_hessians(d, Contacts::left_out, matrix);
  add_unsymmetric(d, Contacts::left_out, beyond);
}

double StepBalance::longest_share(const Increment& d, const Eigen::VectorXd& change) {
  double longest = 0;
  for (Eigen::Index n = 0; n < change.size(); n += 3) longest = std::max(longest, change.segment<3>(n).squaredNorm());
  double share = longest > step_.reach * step_.reach ? step_.reach / std::sqrt(longest) : 1;
  scaled_ = share_ * d;
  part_ = share_ * change;
  for (const auto& effect : composition_->effects)
    if (effect->smooth()) share = std::min(share, effect->longest_share(scaled_, part_));
  return share;
}

}  // namespace talus
