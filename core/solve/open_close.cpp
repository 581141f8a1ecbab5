#include "solve/open_close.hpp"

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
/// A full step that leaves less than this share of the residual needs no search.
constexpr double worthwhile = 0.9;
/// Nor does one whose slope turns round by no more than this share …
constexpr double turned_round = 0.5;
/// … or that leaves a part of the bodies with less than this share of what all are out of balance by: a direction is no
/// more exact than that.
constexpr double slight_share = 1e-3;
/// Iterations of a step in which contacts are closed together: later ones mostly go round in circles.
constexpr int early_tries = 2;
/// With care, a coupled step is kept that leaves less than this share.
constexpr double well_worthwhile = 0.3;
/// Strengths are held until so much is left of what was out of balance when they were taken.
constexpr double near_floor = 0.01;
/// Of the mesh size: the first iteration takes contacts that are open by less for closed and sticking. A block that is
/// only just set down has no force from its contacts yet; a tangent without them would send it through the ground.
constexpr double closing_tolerance = 2e-7;
/// Of the residual at which a step has settled: systems that together are out of balance by less are left alone.
constexpr double negligible_share = 0.1;

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

std::map<std::string, OpenClose::EffectWork> OpenClose::effect_work() const {
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

void OpenClose::end_stage() {
  earlier_work_ = effect_work();
  effect_work_.clear();
}

void OpenClose::begin_stage(Composition& composition) {
  composition_ = &composition;
  effect_work_.assign(composition.effects.size(), {.built = 1});
  works_.assign(composition.effects.size(), 0);
  norms_.assign(composition.effects.size(), 0);
  constant_length_ = 0;
}

SolveTimes OpenClose::times() const {
  SolveTimes times = times_;
  times.assemble += interior_.times().assemble;
  times.factor += linear_.work().factor_seconds + interior_.times().factor;
  times.solve += linear_.work().solve_seconds + interior_.times().solve;
  return times;
}

void OpenClose::set_pattern(int nodes, std::vector<std::pair<int, int>> couplings) {
  const Stopwatch watch(times_.factor);
  for (const auto& effect : composition_->effects) effect->add_couplings(couplings);
  const BlockPattern pattern(nodes, std::move(couplings));
  constant_.set_pattern(pattern);
  of_step_.set_pattern(pattern);
  matrix_.set_pattern(pattern);
  beyond_.set_pattern(pattern);
  linear_.set_pattern(pattern);
  search_.set_size(nodes);
  zero_.setZero(3 * nodes);
  pattern_changed_ = true;
  rounding_ = rounding_of_positions_ = 0;
}

void OpenClose::assemble_constant(const StepContext& step) {
  const bool same_sizes = step.length == constant_length_ && step.integration == constant_integration_;
  if (same_sizes && !pattern_changed_) return;
  if (!same_sizes) linear_.outdate();
  constant_length_ = step.length;
  constant_integration_ = step.integration;
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

void OpenClose::begin_step(const StepContext& step) {
  const Stopwatch watch(times_.assemble);
  share_ = step.integration.smooth_share();
  mesh_size_ = step.mesh_size;
  reach_ = step.reach;
  tolerance_ = step.dynamic_factor > 0 ? settings_.tolerance : settings_.static_tolerance;
  extent_ = step.extent;
  assemble_constant(step);
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
}

void OpenClose::evaluate(const Increment& d, Friction friction) {
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

void OpenClose::hold(const Increment& d) {
  held_.setZero(d.size());
  if (!composition_->bodies->mean_arms) return;
  held_ = -gradient_;
  evaluate(d, Friction::lagged);  // what has a potential, less what there is
  held_.swap(gradient_);
  held_ *= -1;
  gradient_ *= -1;
}

double OpenClose::residual_at(const Increment& d) {
  evaluate(d, Friction::coupled);
  return gradient_.norm();
}

double OpenClose::imbalance() const {
  double inertia = 0, largest = 0;
  for (std::size_t i = 0; i < norms_.size(); ++i) {
    const bool kinetic = composition_->effects[i]->account() == EnergyAccount::kinetic;
    double& norm = kinetic ? inertia : largest;
    norm = std::max(norm, norms_[i]);
  }
  return largest > 0 ? inertia / largest : 0;
}

void OpenClose::solve_at_the_start(Friction friction) {
  assemble(zero_, closing_tolerance);
  linear_.outdate();  // solved exactly
  beyond_.set_zero();
  if (friction == Friction::coupled) add_unsymmetric(zero_, Contacts::included, beyond_);
  linear_.solve(matrix_, beyond_, gradient_, 0, direction_);
}

const Eigen::VectorXd& OpenClose::start_accelerations(const StepContext& step) {
  evaluate(zero_, Friction::coupled);
  for (const auto& effect : composition_->effects) {
    if (effect->account() != EnergyAccount::kinetic) continue;
    part_.setZero();
    effect->add_gradient(zero_, part_);
    gradient_ -= part_;
  }
  solve_at_the_start(Friction::lagged);
  if (ShearContact* shear = composition_->shear; shear && shear->let_slide(-direction_)) {
    solve_at_the_start(Friction::coupled);
    shear->stick();
  }
  direction_ *= -(1 - step.integration.alpha_m) / (step.integration.beta * step.length * step.length);
  return direction_;
}

void OpenClose::assemble(const Increment& d, double touching) {
  const Stopwatch watch(times_.assemble);
  for (NormalContact* normal : composition_->normal) normal->count_as_closed(touching);
  if (composition_->shear) composition_->shear->count_as_closed(touching);
  matrix_.assign(of_step_);
  add_hessians(d, Contacts::included, matrix_);
}

void OpenClose::add_hessians(const Increment& d, Contacts contacts, SymmetricBlocks& matrix) {
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

void OpenClose::add_unsymmetric(const Increment& d, Contacts contacts, UnsymmetricBlocks& beyond) {
  for (const auto& effect : composition_->effects)
    if (contacts == Contacts::included || effect->account() != EnergyAccount::contact)
      effect->add_unsymmetric(d, beyond);
}

void OpenClose::find_direction(const Increment& d, Friction friction) {
  beyond_.set_zero();
  if (friction == Friction::coupled) {
    const Stopwatch watch(times_.assemble);
    add_unsymmetric(d, Contacts::included, beyond_);
  }
  search_.pick_pending(gradient_, part_);
  linear_.solve(matrix_, beyond_, part_, negligible_share * tolerance_ * force_scale_, direction_);
  part_ = -direction_;
  direction_ *= longest_share(d, part_);
}

double OpenClose::longest_share(const Increment& d, const Eigen::VectorXd& change) {
  double longest = 0;
  for (Eigen::Index n = 0; n < change.size(); n += 3) longest = std::max(longest, change.segment<3>(n).squaredNorm());
  double share = longest > reach_ * reach_ ? reach_ / std::sqrt(longest) : 1;
  scaled_ = share_ * d;
  part_ = share_ * change;
  for (const auto& effect : composition_->effects)
    if (effect->smooth()) share = std::min(share, effect->longest_share(scaled_, part_));
  return share;
}

void OpenClose::step_from_start(Increment& d, Friction friction) {
  search_.step_along(direction_, scaled_);
  composition_->bodies->advance(start_, scaled_, d);
  evaluate(d, friction);
}

double OpenClose::slight_residual() const {
  return std::max(slight_share * gradient_.norm(), tolerance_ * force_scale_);
}

void OpenClose::begin_search(const Increment& d) {
  together_.reset(static_cast<int>(d.size() / 3));
  composition_->bodies->join_freedoms(together_);
  part_ = -direction_;
  for (const NormalContact* normal : composition_->normal) normal->join_meeting(d, part_, together_);
  if (composition_->shear) composition_->shear->join_strong(together_);
  search_.set_parts(together_);
  search_.begin(gradient_, direction_);
}

void OpenClose::move(Increment& d, bool early) {
  begin_search(d);
  const double slight = slight_residual();
  start_ = d;
  step_from_start(d, Friction::coupled);
  search_.leave(gradient_, direction_, [slight](const PartwiseSearch::State& part) {
    const bool little_turned = part.slope_before < 0 && std::abs(part.slope) < -turned_round * part.slope_before;
    return part.residual < std::max(worthwhile * part.residual_before, slight) || little_turned;
  });
  if (!search_.any_pending() || (early && another_step_leads_on(d))) return;
  // Where the full step leads astray, one with the strengths of this iterate: then there is a potential, it falls along
  // the direction, and its floor is found by its slope. Often that is the narrow range in which a contact sticks, with
  // sliding one way before and the other way behind it.
  search_.go_back(start_, d);
  evaluate(d, Friction::coupled);
  hold(d);
  if (early) prepare(d, 0);
  find_direction(d, Friction::lagged);
  go_to_the_floor(d);
  evaluate(d, Friction::coupled);
}

bool OpenClose::another_step_leads_on(Increment& d) {
  second_start_ = start_;
  prepare(d, 0);
  find_direction(d, Friction::coupled);
  start_ = d;
  step_from_start(d, Friction::coupled);
  start_ = second_start_;
  search_.leave(gradient_, direction_,
                [](const PartwiseSearch::State& part) { return part.residual < worthwhile * part.residual_before; });
  return !search_.any_pending();
}

void OpenClose::go_to_the_floor(Increment& d) {
  begin_search(d);
  const double slight = slight_residual();
  step_from_start(d, Friction::lagged);
  for (int k = 0; k < settings_.shortenings && search_.narrow(gradient_, direction_, slight); ++k)
    step_from_start(d, Friction::lagged);
}

void OpenClose::prepare(const Increment& d, double touching) {
  assemble(d, touching);
  const double stiffness = matrix_.diagonal_norm();
  rounding_ = std::numeric_limits<double>::epsilon() * mesh_size_ * stiffness;
  rounding_of_positions_ = std::numeric_limits<double>::epsilon() * extent_ * stiffness;
}

Settling OpenClose::settle(Increment& d) {
  Settling result;
  double least = 1e300;  // that was half of what was least before
  int in_vain = 0, stalls = 0;
  bool may_go_inside = can_settle_from_inside();
  first_guess_ = d;
  evaluate(d, Friction::coupled);
  for (;; ++result.iterations) {
    result.residual = gradient_.norm();
    result.force_scale = force_scale_;
    if (!std::isfinite(result.residual)) return result;
    const double round_off = std::max(settings_.round_off * force_scale_, settings_.rounding * rounding_);
    stalls = result.residual > 0.5 * least ? stalls + 1 : 0;
    if (stalls == 0) least = result.residual;
    const bool stalled = stalls >= 2 && result.residual <= round_off;
    const bool stands = result.iterations == 0 && result.residual <= rounding_of_positions_ && d.isZero(0);
    result.settled = result.residual <= tolerance_ * force_scale_ || stalled || stands;
    if (result.settled || result.iterations >= settings_.iteration_limit) break;
    if (result.iterations >= settings_.slow && result.worst_freedom < 0) result.worst_freedom = worst_freedom();
    if (in_vain == settings_.patience) {
      in_vain = 0;
      if (!settle_patiently(d, result.iterations, may_go_inside)) break;
      continue;
    }
    prepare(d, result.iterations == 0 ? closing_tolerance : 0);
    search_.take_all();
    find_direction(d, Friction::coupled);
    move(d, in_vain < early_tries);
    ++in_vain;
  }
  if (result.settled) return result;
  result.residual = gradient_.norm();
  result.worst_freedom = worst_freedom();
  return result;
}

bool OpenClose::settle_patiently(Increment& d, int& iterations, bool& may_go_inside) {
  const int left = settings_.iteration_limit - iterations - 1;
  const int with_care = may_go_inside ? std::min(left, settings_.interior_after - iterations) : left;
  const int count = with_care > 0 ? settle_with_care(d, with_care) : 0;
  iterations += count;
  if (!may_go_inside || count < with_care) return true;
  may_go_inside = false;
  d = first_guess_;
  iterations += settle_from_inside(d, left - count);
  return !is_astray(settings_.iteration_limit - iterations);
}

bool OpenClose::is_astray(int iterations_left) const {
  return gradient_.norm() > settings_.interior_astray * force_scale_ && interior_.points() > iterations_left;
}

bool OpenClose::can_settle_from_inside() const {
  if (!composition_->links) return false;
  const ContactSet& contacts = composition_->links->contacts();
  return !contacts.loose.empty() && contacts.bonded.empty() && zero_.size() <= settings_.interior_unknowns;
}

int OpenClose::settle_from_inside(Increment& d, int limit) {
  const auto add_gradient = [&](const Increment& at, Eigen::VectorXd& sum) {
    scaled_ = share_ * at;
    for (std::size_t i = 0; i < composition_->effects.size(); ++i) {
      const Effect& effect = *composition_->effects[i];
      if (effect.account() == EnergyAccount::contact) continue;
      const Stopwatch seconds(effect_work_[i].seconds);
      effect.add_gradient(effect.smooth() ? scaled_ : at, sum);
      ++effect_work_[i].evaluations;
    }
  };
  const auto assemble_rest = [&](const Increment& at, SymmetricBlocks& matrix, UnsymmetricBlocks& beyond) {
    matrix.assign(of_step_);
    add_hessians(at, Contacts::left_out, matrix);
    add_unsymmetric(at, Contacts::left_out, beyond);
  };
  const auto share = [&](const Increment& at, const Eigen::VectorXd& change) { return longest_share(at, change); };
  const auto is_near = [&](const Increment& at) { return residual_at(at) < settings_.interior_share * force_scale_; };
  const int count = interior_.approach({.bodies = *composition_->bodies,
                                        .links = *composition_->links,
                                        .pattern = matrix_.pattern(),
                                        .add_gradient = add_gradient,
                                        .assemble = assemble_rest,
                                        .longest_share = share,
                                        .is_near = is_near},
                                       std::min(limit, settings_.interior_limit), d);
  evaluate(d, Friction::coupled);
  return count;
}

int OpenClose::worst_freedom() const {
  if (gradient_.size() == 0) return -1;
  Eigen::Index worst = 0;
  gradient_.cwiseAbs().maxCoeff(&worst);
  return static_cast<int>(worst / 3);
}

int OpenClose::settle_with_care(Increment& d, int limit) {
  double before = gradient_.norm();
  int count = 0;
  hold(d);
  for (; count < limit; ++count) {
    prepare(d, 0);
    search_.take_all();
    find_direction(d, Friction::lagged);
    start_ = d;
    go_to_the_floor(d);
    const double negligible = std::max(tolerance_ * force_scale_, settings_.rounding * rounding_);
    if (gradient_.norm() > std::max(near_floor * before, negligible)) continue;
    evaluate(d, Friction::coupled);
    before = gradient_.norm();
    if (before <= negligible || coupled_step_is_worthwhile(d)) return count;
    hold(d);
  }
  evaluate(d, Friction::coupled);
  return count;
}

bool OpenClose::coupled_step_is_worthwhile(Increment& d) {
  const double before = gradient_.norm();
  search_.take_all();
  find_direction(d, Friction::coupled);
  begin_search(d);
  start_ = d;
  step_from_start(d, Friction::coupled);
  search_.leave(gradient_, direction_, [](const PartwiseSearch::State& part) {
    return part.residual < well_worthwhile * part.residual_before;
  });
  if (search_.any_pending()) {
    search_.go_back(start_, d);
    evaluate(d, Friction::coupled);
  }
  return gradient_.norm() < well_worthwhile * before;
}

}  // namespace talus
