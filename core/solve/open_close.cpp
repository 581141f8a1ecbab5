#include "solve/open_close.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solve/stopwatch.hpp"

namespace talus {

namespace {

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

}  // namespace

void OpenClose::begin_stage(Composition& composition) {
  composition_ = &composition;
  balance_.begin_stage(composition);
}

SolveTimes OpenClose::times() const {
  SolveTimes times = balance_.times();
  times.assemble += interior_.times().assemble;
  times.factor += pattern_seconds_ + linear_.work().factor_seconds + interior_.times().factor;
  times.solve += linear_.work().solve_seconds + interior_.times().solve;
  return times;
}

void OpenClose::set_pattern(int nodes, std::vector<std::pair<int, int>> couplings) {
  const Stopwatch watch(pattern_seconds_);
  balance_.set_pattern(nodes, std::move(couplings));
  const BlockPattern& pattern = balance_.matrix().pattern();
  beyond_.set_pattern(pattern);
  linear_.set_pattern(pattern);
  search_.set_size(nodes);
  zero_.setZero(3 * nodes);
}

void OpenClose::begin_step(const StepContext& step) {
  tolerance_ = step.dynamic_factor > 0 ? settings_.tolerance : settings_.static_tolerance;
  if (balance_.begin_step(step)) linear_.outdate();
}

double OpenClose::residual_at(const Increment& d) {
  balance_.evaluate(d, Friction::coupled);
  return balance_.residual();
}

void OpenClose::solve_at_the_start(Friction friction) {
  balance_.assemble(zero_, closing_tolerance);
  linear_.outdate();  // solved exactly
  beyond_.set_zero();
  if (friction == Friction::coupled) balance_.add_beyond(zero_, beyond_);
  linear_.solve(balance_.matrix(), beyond_, balance_.gradient(), 0, direction_);
}

const Eigen::VectorXd& OpenClose::start_accelerations(const StepContext& step) {
  balance_.evaluate_without_inertia();
  solve_at_the_start(Friction::lagged);
  if (ShearContact* shear = composition_->shear; shear && shear->let_slide(-direction_)) {
    solve_at_the_start(Friction::coupled);
    shear->stick();
  }
  direction_ *= -(1 - step.integration.alpha_m) / (step.integration.beta * step.length * step.length);
  return direction_;
}

void OpenClose::find_direction(const Increment& d, Friction friction) {
  beyond_.set_zero();
  if (friction == Friction::coupled) balance_.add_beyond(d, beyond_);
  search_.pick_pending(balance_.gradient(), part_);
  linear_.solve(balance_.matrix(), beyond_, part_, negligible_share * tolerance_ * balance_.force_scale(), direction_);
  part_ = -direction_;
  direction_ *= balance_.longest_share(d, part_);
}

void OpenClose::step_from_start(Increment& d, Friction friction) {
  search_.step_along(direction_, scaled_);
  composition_->bodies->advance(start_, scaled_, d);
  balance_.evaluate(d, friction);
}

double OpenClose::slight_residual() const {
  return std::max(slight_share * balance_.residual(), tolerance_ * balance_.force_scale());
}

void OpenClose::begin_search(const Increment& d) {
  together_.reset(static_cast<int>(d.size() / 3));
  composition_->bodies->join_freedoms(together_);
  part_ = -direction_;
  for (const NormalContact* normal : composition_->normal) normal->join_meeting(d, part_, together_);
  if (composition_->shear) composition_->shear->join_strong(together_);
  search_.set_parts(together_);
  search_.begin(balance_.gradient(), direction_);
}

void OpenClose::move(Increment& d, bool early) {
  begin_search(d);
  const double slight = slight_residual();
  start_ = d;
  step_from_start(d, Friction::coupled);
  search_.leave(balance_.gradient(), direction_, [slight](const PartwiseSearch::State& part) {
    const bool little_turned = part.slope_before < 0 && std::abs(part.slope) < -turned_round * part.slope_before;
    return part.residual < std::max(worthwhile * part.residual_before, slight) || little_turned;
  });
  if (!search_.any_pending() || (early && another_step_leads_on(d))) return;
  // Where the full step leads astray, one with the strengths of this iterate: then there is a potential, it falls along
  // the direction, and its floor is found by its slope. Often that is the narrow range in which a contact sticks, with
  // sliding one way before and the other way behind it.
  search_.go_back(start_, d);
  balance_.evaluate(d, Friction::coupled);
  balance_.hold(d);
  if (early) prepare(d, 0);
  find_direction(d, Friction::lagged);
  go_to_the_floor(d);
  balance_.evaluate(d, Friction::coupled);
}

bool OpenClose::another_step_leads_on(Increment& d) {
  second_start_ = start_;
  prepare(d, 0);
  find_direction(d, Friction::coupled);
  start_ = d;
  step_from_start(d, Friction::coupled);
  start_ = second_start_;
  search_.leave(balance_.gradient(), direction_,
                [](const PartwiseSearch::State& part) { return part.residual < worthwhile * part.residual_before; });
  return !search_.any_pending();
}

void OpenClose::go_to_the_floor(Increment& d) {
  begin_search(d);
  const double slight = slight_residual();
  step_from_start(d, Friction::lagged);
  for (int k = 0; k < settings_.shortenings && search_.narrow(balance_.gradient(), direction_, slight); ++k)
    step_from_start(d, Friction::lagged);
}

void OpenClose::prepare(const Increment& d, double touching) {
  balance_.assemble(d, touching);
  balance_.measure_rounding();
}

Settling OpenClose::settle(Increment& d) {
  Settling result;
  double least = 1e300;  // that was half of what was least before
  int in_vain = 0, stalls = 0;
  bool may_go_inside = can_settle_from_inside();
  first_guess_ = d;
  balance_.evaluate(d, Friction::coupled);
  for (;; ++result.iterations) {
    result.residual = balance_.residual();
    result.force_scale = balance_.force_scale();
    if (!std::isfinite(result.residual)) return result;
    const double round_off =
        std::max(settings_.round_off * balance_.force_scale(), settings_.rounding * balance_.rounding());
    stalls = result.residual > 0.5 * least ? stalls + 1 : 0;
    if (stalls == 0) least = result.residual;
    const bool stalled = stalls >= 2 && result.residual <= round_off;
    const bool stands = result.iterations == 0 && result.residual <= balance_.rounding_of_positions() && d.isZero(0);
    result.settled = result.residual <= tolerance_ * balance_.force_scale() || stalled || stands;
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
  result.residual = balance_.residual();
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
  return balance_.residual() > settings_.interior_astray * balance_.force_scale() &&
         interior_.points() > iterations_left;
}

bool OpenClose::can_settle_from_inside() const {
  if (!composition_->links) return false;
  const ContactSet& contacts = composition_->links->contacts();
  return !contacts.loose.empty() && contacts.bonded.empty() && zero_.size() <= settings_.interior_unknowns;
}

int OpenClose::settle_from_inside(Increment& d, int limit) {
  const auto add_gradient = [this](const Increment& at, Eigen::VectorXd& sum) {
    balance_.add_gradient_of_rest(at, sum);
  };
  const auto assemble = [this](const Increment& at, SymmetricBlocks& matrix, UnsymmetricBlocks& beyond) {
    balance_.assemble_rest(at, matrix, beyond);
  };
  const auto longest_share = [this](const Increment& at, const Eigen::VectorXd& change) {
    return balance_.longest_share(at, change);
  };
  const auto is_near = [this](const Increment& at) {
    return residual_at(at) < settings_.interior_share * balance_.force_scale();
  };
  const int count = interior_.approach({.bodies = *composition_->bodies,
                                        .links = *composition_->links,
                                        .pattern = balance_.matrix().pattern(),
                                        .add_gradient = add_gradient,
                                        .assemble = assemble,
                                        .longest_share = longest_share,
                                        .is_near = is_near},
                                       std::min(limit, settings_.interior_limit), d);
  balance_.evaluate(d, Friction::coupled);
  return count;
}

int OpenClose::worst_freedom() const {
  if (balance_.gradient().size() == 0) return -1;
  Eigen::Index worst = 0;
  balance_.gradient().cwiseAbs().maxCoeff(&worst);
  return static_cast<int>(worst / 3);
}

int OpenClose::settle_with_care(Increment& d, int limit) {
  double before = balance_.residual();
  int count = 0;
  balance_.hold(d);
  for (; count < limit; ++count) {
    prepare(d, 0);
    search_.take_all();
    find_direction(d, Friction::lagged);
    start_ = d;
    go_to_the_floor(d);
    const double negligible = std::max(tolerance_ * balance_.force_scale(), settings_.rounding * balance_.rounding());
    if (balance_.residual() > std::max(near_floor * before, negligible)) continue;
    balance_.evaluate(d, Friction::coupled);
    before = balance_.residual();
    if (before <= negligible || coupled_step_is_worthwhile(d)) return count;
    balance_.hold(d);
  }
  balance_.evaluate(d, Friction::coupled);
  return count;
}

bool OpenClose::coupled_step_is_worthwhile(Increment& d) {
  const double before = balance_.residual();
  search_.take_all();
  find_direction(d, Friction::coupled);
  begin_search(d);
  start_ = d;
  step_from_start(d, Friction::coupled);
  search_.leave(balance_.gradient(), direction_, [](const PartwiseSearch::State& part) {
    return part.residual < well_worthwhile * part.residual_before;
  });
  if (search_.any_pending()) {
    search_.go_back(start_, d);
    balance_.evaluate(d, Friction::coupled);
  }
  return balance_.residual() < well_worthwhile * before;
}

}  // namespace talus
