#include "solve/equilibrium/step_residual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/stopwatch.hpp"

namespace talus {

std::map<EffectKind, StepResidual::EffectWork> StepResidual::effect_work() const {
  std::map<EffectKind, EffectWork> all = earlier_work_;
  for (std::size_t i = 0; i < effect_work_.size(); ++i) {
    EffectWork& sum = all[composition_->effects[i]->kind()];
    sum.seconds += effect_work_[i].seconds;
    sum.built += effect_work_[i].built;
    sum.evaluations += effect_work_[i].evaluations;
    sum.assemblies += effect_work_[i].assemblies;
  }
  return all;
}

void StepResidual::end_stage() {
  earlier_work_ = effect_work();
  effect_work_.clear();
}

void StepResidual::begin_stage(Composition& composition) {
  composition_ = &composition;
  effect_work_.assign(composition.effects.size(), {.built = 1});
  works_.assign(composition.effects.size(), 0);
  norms_.assign(composition.effects.size(), 0);
  step_.length = 0;
  find_contact_effects();
}

void StepResidual::find_contact_effects() {
  std::vector<ContactEffect*> effects;
  contact_numbers_.clear();
  for (std::size_t i = 0; i < composition_->effects.size(); ++i)
    if (auto* effect = dynamic_cast<ContactEffect*>(composition_->effects[i].get())) {
      effects.push_back(effect);
      contact_numbers_.push_back(i);
    }
  contact_.set(std::move(effects));
}

void StepResidual::put_in(const PutIn& where) {
  const auto make_room = [&](auto& list, const auto& value) {
    list.insert(list.begin() + where.place, where.count, value);
  };
  make_room(effect_work_, EffectWork{.built = 1});
  make_room(works_, 0.0);
  make_room(norms_, 0.0);
  step_.length = 0;
  find_contact_effects();
}

void StepResidual::set_pattern(int dof_blocks, std::vector<std::pair<int, int>> couplings) {
  for (const auto& effect : composition_->effects) effect->add_couplings(couplings);
  set_pattern(BlockPattern(dof_blocks, std::move(couplings)));
}

void StepResidual::set_pattern(const BlockPattern& pattern) {
  constant_.set_pattern(pattern);
  of_step_.set_pattern(pattern);
  matrix_.set_pattern(pattern);
  unsymmetric_.set_pattern(pattern);
  zero_.setZero(3 * pattern.nodes());
  pattern_changed_ = true;
  rounding_ = rounding_of_positions_ = 0;
  const BodySet& bodies = *composition_->bodies;
  body_begins_ = {0};
  for (const int b : bodies.moving) {
    const Body& body = bodies.bodies[b];
    body_begins_.push_back(body_begins_.back() + (body.rigid >= 0 ? 2 : body.free_count()));
  }
  body_roundings_.setZero(this->bodies());
  body_forces_.setZero(this->bodies());
  find_systems(pattern);
}

void StepResidual::find_systems(const BlockPattern& pattern) {
  system_of_.resize(pattern.nodes());
  systems_.clear();
  for (const std::vector<int>& blocks : pattern.connected_parts()) {
    for (const int block : blocks) system_of_[block] = systems();
    systems_.emplace_back();
  }
  for (int b = 0; b < bodies(); ++b)
    for (int block = body_begins_[b]; block < body_begins_[b + 1]; ++block) {
      std::vector<int>& listed = systems_[system_of_[block]].bodies;
      if (listed.empty() || listed.back() != b) listed.push_back(b);
    }
}

template <class Use>
void StepResidual::each_body(const Use& use) const {
  if (picked_)
    for (const int b : picked_->places) use(b);
  else
    for (int b = 0; b < bodies(); ++b) use(b);
}

void StepResidual::measure_systems(const Eigen::VectorXd& vector, double System::*norm) {
  for (System& system : systems_) system.*norm = 0;
  each_body([&](int b) {
    for (int block = body_begins_[b]; block < body_begins_[b + 1]; ++block)
      systems_[system_of_[block]].*norm += vector.segment<3>(3 * block).squaredNorm();
  });
  for (System& system : systems_) system.*norm = std::sqrt(system.*norm);
}

bool StepResidual::each_body_within(int system, double fraction) const {
  const std::vector<int>& bodies = systems_[system].bodies;
  return std::all_of(bodies.begin(), bodies.end(), [&](int b) { return body_within(b, fraction); });
}

bool StepResidual::each_body_balances(int system, double tolerance) const {
  const System& s = systems_[system];
  if (std::abs(s.work) > tolerances_.work_of_residual * tolerance * s.works_together) return false;
  return each_body_within(system, tolerance);
}

bool StepResidual::each_body_within_rounding() const {
  for (int b = 0; b < bodies(); ++b)
    if (norm_of_body(gradient_, b) > body_roundings_[b]) return false;
  return true;
}

bool StepResidual::body_within(int body, double fraction) const {
  return norm_of_body(gradient_, body) <= fraction * body_forces_[body];
}

void StepResidual::list_unbalanced(double fraction, std::vector<int>& bodies) const {
  bodies.clear();
  each_body([&](int b) {
    if (!body_within(b, fraction)) bodies.push_back(b);
  });
}

void StepResidual::look_at(const PickedBodies* picked) {
  picked_ = picked;
  others_left_out_ = !picked;
  for (const auto& effect : composition_->effects) effect->look_at(picked);
}

void StepResidual::clear(Eigen::VectorXd& forces) const {
  if (!picked_)
    forces.setZero();
  else
    for (const int block : picked_->dof_blocks) forces.segment<3>(3 * block).setZero();
}

void StepResidual::assemble_constant() {
  pattern_changed_ = false;
  constant_.set_zero();
  for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
    const Effect& effect = *composition_->effects[i];
    if (!effect.constant()) continue;
    const Stopwatch of_effect(effect_work_[i].seconds);
    constant_.set_weight(effect.smooth() ? smooth_fraction_ : 1);
    effect.add_hessian(zero_, constant_);
    ++effect_work_[i].assemblies;
  }
}

bool StepResidual::weights_of_inertia_changed() {
  bool changed = false;
  const std::vector<Body>& bodies = composition_->bodies->bodies;
  constant_accelerations_.resize(bodies.size(), false);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const bool now = bodies[b].constant_acceleration && bodies[b].rigid < 0;
    changed = std::exchange(constant_accelerations_[b], now) != now || changed;
  }
  return changed;
}

bool StepResidual::begin_step(const StepContext& step) {
  const Stopwatch watch(times_.assemble);
  const bool weights_changed = weights_of_inertia_changed();
  const bool same_kind = step.length == step_.length && step.integration == step_.integration && !weights_changed;
  step_ = step;
  smooth_fraction_ = step.integration.smooth_fraction();
  if (!same_kind || pattern_changed_) assemble_constant();
  of_step_.assign(constant_);
  part_.resize(zero_.size());
  momentum_scale_ = 0;
  body_momenta_.setZero(bodies());
  for (System& system : systems_) system.momentum = 0;
  for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
    const Effect& effect = *composition_->effects[i];
    const Stopwatch of_effect(effect_work_[i].seconds);
    of_step_.set_weight(effect.smooth() ? smooth_fraction_ : 1);
    if (effect.quadratic() && !effect.constant()) {
      effect.add_hessian(zero_, of_step_);
      ++effect_work_[i].assemblies;
    }
    if (effect.account() != EnergyAccount::kinetic) continue;
    part_.setZero();
    effect.add_gradient(zero_, step_.arms, part_);
    momentum_scale_ = tolerances_.momentum_force_weight * part_.norm();
    for (int b = 0; b < bodies(); ++b) body_momenta_[b] = tolerances_.momentum_force_weight * norm_of_body(part_, b);
    measure_systems(part_, &System::momentum);
    for (System& system : systems_) system.momentum *= tolerances_.momentum_force_weight;
  }
  return !same_kind;
}

void StepResidual::evaluate(const Increment& d, Friction friction) {
  const Stopwatch watch(times_.update);
  const Arms arms = friction == Friction::frozen ? Arms::end : step_.arms;  // frozen forces have a potential
  gradient_.resize(d.size());
  part_.resize(d.size());
  scaled_ = smooth_fraction_ * d;
  if (!std::exchange(others_left_out_, true)) gradient_.setZero();
  clear(gradient_);
  if (friction == Friction::frozen) each_body([&](int b) { of_body(gradient_, b) = of_body(frozen_, b); });
  force_scale_ = picked_ ? 0 : momentum_scale_;
  for (System& system : systems_) {
    system.scale = picked_ ? 0 : system.momentum;
    system.work = system.works_together = 0;
  }
  each_body([&](int b) { body_forces_[b] = body_momenta_[b]; });
  Laps laps;
  for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
    const Effect& effect = *composition_->effects[i];
    if (effect.account() == EnergyAccount::contact) continue;
    clear(part_);
    effect.add_gradient(effect.smooth() ? scaled_ : d, arms, part_);
    add_effect(i, d, part_);
    ++effect_work_[i].evaluations;
    laps.add_to(effect_work_[i].seconds);
  }
  evaluate_contact(d, arms, friction);
  measure_systems(gradient_, &System::norm);
}

void StepResidual::evaluate_contact(const Increment& d, Arms arms, Friction friction) {
  if (contact_.effects().empty()) return;
  double seconds = 0;
  Laps laps;
  contact_parts_.resize(contact_.effects().size());
  for (Eigen::VectorXd& part : contact_parts_) {
    part.resize(d.size());
    clear(part);
  }
  if (composition_->shear && friction == Friction::coupled) composition_->shear->clear_strength();
  contact_.add_gradients(d, arms, friction == Friction::coupled, contact_parts_);
  for (std::size_t k = 0; k < contact_parts_.size(); ++k) add_effect(contact_numbers_[k], d, contact_parts_[k]);
  laps.add_to(seconds);
  for (const std::size_t i : contact_numbers_) {
    effect_work_[i].seconds += seconds / static_cast<double>(contact_numbers_.size());
    ++effect_work_[i].evaluations;
  }
}

void StepResidual::add_effect(std::size_t effect, const Increment& d, const Eigen::VectorXd& part) {
  const bool elastic = composition_->effects[effect]->account() == EnergyAccount::elastic;
  const double counts = elastic ? tolerances_.elastic_force_weight : 1;
  for (System& system : systems_) system.of_effect = system.work_of_effect = 0;
  each_body([&](int b) {
    double square_of_body = 0;
    for (int block = body_begins_[b]; block < body_begins_[b + 1]; ++block) {
      const auto force = part.segment<3>(3 * block);
      gradient_.segment<3>(3 * block) += force;
      const double square = force.squaredNorm();
      square_of_body += square;
      System& system = systems_[system_of_[block]];
      system.of_effect += square;
      system.work_of_effect += force.dot(d.segment<3>(3 * block));
    }
    body_forces_[b] = std::max(body_forces_[b], counts * std::sqrt(square_of_body));
  });
  double square = 0;
  works_[effect] = 0;
  for (System& system : systems_) {
    system.scale = std::max(system.scale, counts * std::sqrt(system.of_effect));
    system.work += system.work_of_effect;
    system.works_together += std::abs(system.work_of_effect);
    square += system.of_effect;
    works_[effect] += system.work_of_effect;
  }
  norms_[effect] = std::sqrt(square);
  force_scale_ = std::max(force_scale_, counts * norms_[effect]);
}

void StepResidual::freeze(const Increment& d) {
  frozen_.setZero(d.size());
  if (step_.arms == Arms::end) return;
  frozen_ = -gradient_;
  evaluate(d, Friction::frozen);  // what has a potential, less what there is
  frozen_.swap(gradient_);
  frozen_ *= -1;
  gradient_ *= -1;
  measure_systems(gradient_, &System::norm);
}

void StepResidual::evaluate_without_inertia() {
  evaluate(zero_, Friction::coupled);
  for (const auto& effect : composition_->effects) {
    if (effect->account() != EnergyAccount::kinetic) continue;
    part_.setZero();
    effect->add_gradient(zero_, step_.arms, part_);
    gradient_ -= part_;
  }
}

double StepResidual::static_residual() const {
  double inertia = 0, largest = 0;
  for (std::size_t i = 0; i < norms_.size(); ++i) {
    const bool kinetic = composition_->effects[i]->account() == EnergyAccount::kinetic;
    double& norm = kinetic ? inertia : largest;
    norm = std::max(norm, norms_[i]);
  }
  return largest > 0 ? inertia / largest : 0;
}

void StepResidual::assemble(const Increment& d, double touching, Friction friction) {
  const Stopwatch watch(times_.assemble);
  for (NormalContact* normal : composition_->normal) normal->count_as_closed(touching);
  if (composition_->shear) composition_->shear->count_as_closed(touching);
  assign_of_step(matrix_);
  unsymmetric_.set_zero();
  add_hessians(d, matrix_);
  if (friction == Friction::coupled) add_unsymmetric(d, unsymmetric_);
  add_contact_tangents(d, friction);
}

void StepResidual::assign_of_step(SymmetricBlocks& matrix) const {
  if (picked_)
    matrix.assign_columns(of_step_, picked_->dof_blocks);
  else
    matrix.assign(of_step_);
}

void StepResidual::add_contact_tangents(const Increment& d, Friction friction) {
  if (contact_.effects().empty()) return;
  double seconds = 0;
  {
    const Stopwatch watch(seconds);
    UnsymmetricBlocks* const unsymmetric = friction == Friction::coupled ? &unsymmetric_ : nullptr;
    contact_.add_tangents(d, step_.arms, matrix_, unsymmetric);
  }
  for (const std::size_t i : contact_numbers_) {
    effect_work_[i].seconds += seconds / static_cast<double>(contact_numbers_.size());
    ++effect_work_[i].assemblies;
  }
}

void StepResidual::add_hessians(const Increment& d, SymmetricBlocks& matrix) {
  scaled_ = smooth_fraction_ * d;
  for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
    const Effect& effect = *composition_->effects[i];
    if (effect.quadratic() || effect.account() == EnergyAccount::contact) continue;
    const Stopwatch of_effect(effect_work_[i].seconds);
    matrix.set_weight(effect.smooth() ? smooth_fraction_ : 1);
    effect.add_hessian(effect.smooth() ? scaled_ : d, matrix);
    ++effect_work_[i].assemblies;
  }
  matrix.set_weight(1);
}

void StepResidual::add_unsymmetric(const Increment& d, UnsymmetricBlocks& sum) const {
  for (const auto& effect : composition_->effects)
    if (effect->account() != EnergyAccount::contact) effect->add_unsymmetric(d, step_.arms, sum);
}

void StepResidual::measure_rounding() {
  if (picked_) return;  // that of all bodies holds
  const double stiffness = matrix_.diagonal_norm();
  rounding_ = std::numeric_limits<double>::epsilon() * step_.mesh_size * stiffness;
  const double of_positions = std::numeric_limits<double>::epsilon() * step_.extent;
  rounding_of_positions_ = of_positions * stiffness;
  for (int b = 0; b < bodies(); ++b)
    body_roundings_[b] = of_positions * matrix_.diagonal_norm(body_begins_[b], body_begins_[b + 1]);
}

void StepResidual::add_gradient_without_contacts(const Increment& d, Eigen::VectorXd& sum) {
  scaled_ = smooth_fraction_ * d;
  for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
    const Effect& effect = *composition_->effects[i];
    if (effect.account() == EnergyAccount::contact) continue;
    const Stopwatch of_effect(effect_work_[i].seconds);
    effect.add_gradient(effect.smooth() ? scaled_ : d, step_.arms, sum);
    ++effect_work_[i].evaluations;
  }
}

void StepResidual::assemble_without_contacts(const Increment& d, SymmetricBlocks& matrix,
                                             UnsymmetricBlocks& unsymmetric) {
  assign_of_step(matrix);
  add_hessians(d, matrix);
  add_unsymmetric(d, unsymmetric);
}

namespace {

double longest_of(const Eigen::VectorXd& change, int begin, int end) {
  double longest = 0;
  for (int n = begin; n < end; ++n) longest = std::max(longest, change.segment<3>(3 * n).squaredNorm());
  return std::sqrt(longest);
}

}  // namespace

double StepResidual::fraction_within_reach(const Eigen::VectorXd& change, int body) const {
  if (!step_.unlimited.empty() && step_.unlimited[composition_->bodies->moving[body]]) return 1;
  const double longest = longest_of(change, body_begins_[body], body_begins_[body + 1]);
  return longest > step_.reach ? step_.reach / longest : 1;
}

void StepResidual::keep_within_reach(Eigen::VectorXd& change) const {
  for (int b = 0; b < bodies(); ++b)
    if (const double fraction = fraction_within_reach(change, b); fraction < 1)
      change.segment(3 * body_begins_[b], 3 * (body_begins_[b + 1] - body_begins_[b])) *= fraction;
}

double StepResidual::longest_step_fraction(const Increment& d, const Eigen::VectorXd& change) {
  double fraction = 1;
  for (int b = 0; b < bodies(); ++b) fraction = std::min(fraction, fraction_within_reach(change, b));
  scaled_ = smooth_fraction_ * d;
  part_ = smooth_fraction_ * change;
  for (const auto& effect : composition_->effects)
    if (effect->smooth()) fraction = std::min(fraction, effect->longest_step_fraction(scaled_, part_));
  return fraction;
}

}  // namespace talus
