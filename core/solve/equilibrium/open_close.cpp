#include "solve/equilibrium/open_close.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "solve/equilibrium/residual_progress.hpp"

namespace talus {

namespace {

/// Numbers of the input that are so unlike each other that one is lost in the rounding of another.
InputError beyond_reason(const NotPositiveDefinite& error) {
  return {"the equations of motion",
          std::string("masses and stiffnesses are too far apart to compute with: ") + error.what(),
          "check the densities, moduli, stiffnesses and sizes, and that something holds each block"};
}

}  // namespace

void OpenClose::begin_stage(Composition& composition, double body_residual) {
  composition_ = &composition;
  body_residual_ = body_residual;
  trials_alone_ = trials_full_ = {};
  residual_.begin_stage(composition);
}

SolveTimes OpenClose::times() const {
  SolveTimes times = residual_.times();
  times.assemble += interior_.times().assemble;
  times.factor += pattern_seconds_ + linear_.work().factor_seconds + interior_.times().factor;
  times.solve += linear_.work().solve_seconds + elimination_seconds_ + interior_.times().solve;
  return times;
}

LinearWork OpenClose::linear_work() const {
  LinearWork work = linear_.work();
  work.factorisations += elimination_.work().factorisations;
  work.gmres_iterations += elimination_.work().gmres_iterations;
  work.gmres_limits += elimination_.work().gmres_limits;
  return work;
}

void OpenClose::set_pattern(int nodes, std::vector<std::pair<int, int>> couplings) {
  const Stopwatch watch(pattern_seconds_);
  residual_.set_pattern(nodes, std::move(couplings));
  linear_.set_pattern(residual_.matrix().pattern());
  follow_pattern();
}

void OpenClose::follow_pattern() {
  const BlockPattern& pattern = residual_.matrix().pattern();
  search_.set_size(pattern.nodes());
  zero_.setZero(3 * pattern.nodes());
}

void OpenClose::archive(StateArchive& state, bool pattern_holds) {
  state(linear_);
  if (state.reads() && pattern_holds) {
    residual_.set_pattern(linear_.pattern());
    follow_pattern();
  }
  state(residual_, interior_, elimination_, trials_alone_, trials_full_, pattern_seconds_, elimination_seconds_,
        alone_);
}

void OpenClose::begin_step(const StepContext& step) {
  is_dynamic_ = step.dynamic_factor > 0;
  tolerance_ = is_dynamic_ ? tolerances_.dynamic_residual : tolerances_.static_residual;
  if (residual_.begin_step(step)) linear_.outdate();
}

double OpenClose::residual_at(const Increment& d) {
  residual_.evaluate(d, Friction::coupled);
  return residual_.norm();
}

void OpenClose::solve_at_step_start(Friction friction) {
  residual_.assemble(zero_, tolerances_.first_closing, friction);
  linear_.demand_factors();  // solved exactly
  linear_.solve(residual_.matrix(), residual_.unsymmetric(), residual_.gradient(), {}, direction_);
}

const Eigen::VectorXd& OpenClose::start_accelerations(const StepContext& step) {
  residual_.evaluate_without_inertia();
  try {
    solve_at_step_start(Friction::frozen);
    if (ShearContact* shear = composition_->shear; shear && shear->let_slide(-direction_)) {
      solve_at_step_start(Friction::coupled);
      shear->stick();
    }
  } catch (const NotPositiveDefinite& error) {
    throw beyond_reason(error);
  }
  direction_ *= -(1 - step.integration.alpha_m) / (step.integration.beta * step.length * step.length);
  return direction_;
}

void OpenClose::release_states() {
  if (composition_) states_.release(*composition_);
}

OpenCloseResult OpenClose::converge_by_states(Increment& d) {
  OpenCloseResult result;
  residual_.evaluate(d, Friction::coupled);
  states_.begin(*composition_, tolerances_.first_closing, d);
  residual_.evaluate(d, Friction::coupled);
  while (result.iterations < iteration_limit_) {
    ++result.iterations;
    assemble(d, 0, Friction::coupled);
    linear_.demand_factors();  // solved exactly
    linear_.solve(residual_.matrix(), residual_.unsymmetric(), residual_.gradient(), {}, direction_);
    start_ = d;
    part_ = -direction_;
    composition_->bodies->advance(start_, part_, d);
    residual_.evaluate(d, Friction::coupled);
    result.residual = residual_.norm();
    result.force_scale = residual_.force_scale();
    if (!std::isfinite(result.residual)) return result;
    const double rounding = std::max(tolerances_.rounding_residual * result.force_scale,
                                     tolerances_.rounding_factor * residual_.rounding());
    const bool balances = result.residual <= rounding;  // of blocks that turn a round is one iteration
    const auto judged = states_.judge(*composition_, d);
    // Friction that is that of the round before will do, (36), if there is no round left to take it anew.
    const bool settled = judged.friction_error <= tolerances_.friction_settled || result.iterations == iteration_limit_;
    result.converged = judged.changed == 0 && settled && balances;
    if (result.converged) return result;
    states_.take_judged();
    residual_.evaluate(d, Friction::coupled);
  }
  result.worst_dof_block = worst_dof_block();
  return result;
}

OpenCloseResult OpenClose::converge(Increment& d, double enough) {
  enough_ = enough;
  if (method_ == OpenCloseMethod::states) return converge_by_states(d);
  residual_.evaluate(d, Friction::coupled);
  try {
    return converge_within(iteration_limit_, interior_point_applies(), d);
  } catch (const NotPositiveDefinite& error) {
    // Inertia leaves no motion without stiffness, unless an iterate has gone so far astray that it is lost in rounding.
    if (!is_dynamic_) throw beyond_reason(error);
    OpenCloseResult lost;
    lost.residual = std::numeric_limits<double>::infinity();
    lost.worst_dof_block = error.node;
    return lost;
  }
}

OpenCloseResult OpenClose::converge_within(int limit, bool interior_point_left, Increment& d) {
  OpenCloseResult result;
  ResidualProgress progress(tolerances_);
  Trials trials_among_few;
  begin_with(d);
  int newton_iterations = 0;  // since the start, or since the last fallback
  for (;; ++result.iterations) {
    result.residual = residual_.norm();
    result.force_scale = residual_.force_scale();
    if (!std::isfinite(result.residual)) return result;
    progress.note(norm_left());
    result.converged = has_converged(result, progress.has_stalled(), d);
    if (result.converged) return result;
    if (result.iterations >= limit) break;
    if (result.iterations >= tolerances_.hard_step && result.worst_dof_block < 0)
      result.worst_dof_block = worst_dof_block();
    if (progress.goes_in_circles()) {
      progress.begin_anew();
      newton_iterations = 0;
      if (!converge_with_fallbacks(d, limit, result.iterations, interior_point_left)) break;
    } else {
      assemble(d, result.iterations == 0 ? tolerances_.first_closing : 0, Friction::coupled);
      search_.set_all_pending();
      find_direction(d, Friction::coupled);
      iterate(d, newton_iterations < tolerances_.closing_iterations);
      ++newton_iterations;
      if (newton_iterations >= tolerances_.closing_iterations && balances_alone_)
        balance_alone(d, elimination_.is_active() ? trials_among_few : trials_alone_);
    }
  }
  result.residual = residual_.norm();
  result.worst_dof_block = worst_dof_block();
  return result;
}

void OpenClose::begin_with(const Increment& d) {
  const auto depth = static_cast<std::size_t>(elimination_.depth());
  if (begun_with_.size() <= depth) begun_with_.resize(depth + 1);
  begun_with_[depth] = d;
}

void OpenClose::balance_alone(Increment& d, Trials& trials) {
  if (!elimination_.begin(*composition_, residual_, {.most = elimination_tolerances_.most_bodies})) return;
  if (!trials.is_due()) return elimination_.end(residual_);
  trials.note(balance_picked(d, elimination_tolerances_.iterations));
  residual_.evaluate(d, Friction::coupled);
}

bool OpenClose::balance_changed(Increment& d) {
  if (!balances_alone_) return false;
  residual_.evaluate(d, Friction::coupled);
  return elimination_.begin(*composition_, residual_,
                            {.most = elimination_tolerances_.few_bodies, .contacts_away = 1}) &&
         balance_picked(d, elimination_tolerances_.iterations);
}

bool OpenClose::balance_picked(Increment& d, int limit) {
  const int depth = elimination_.depth();
  std::optional<Stopwatch> watch;
  if (depth == 1) watch.emplace(alone_.seconds);
  ++alone_.evaluations;
  residual_.evaluate(d, Friction::coupled);
  const double before = residual_.norm();
  double left = std::numeric_limits<double>::infinity();
  try {
    left = converge_within(limit, interior_point_applies(), d).residual;
  } catch (const NotPositiveDefinite&) {  // an iterate has gone far astray
  }
  if (!(left < before)) d = begun_with_[depth];
  elimination_.end(residual_);
  return left < tolerances_.well_reduced * before;
}

bool OpenClose::balances(int system) const {
  if (residual_.norm_of_system(system) <= tolerance_ * residual_.force_scale_of_system(system)) return true;
  if (body_residual_ > 0 && residual_.each_body_balances(system, body_residual_)) return true;
  return enough_ > 0 && !elimination_.is_active() && residual_.each_body_within(system, enough_);
}

double OpenClose::norm_left() const {
  double sum = 0;
  for (int s = 0; s < residual_.systems(); ++s)
    if (!balances(s)) sum += std::pow(residual_.norm_of_system(s), 2);
  return std::sqrt(sum);
}

bool OpenClose::has_converged(const OpenCloseResult& now, bool stalled, const Increment& d) const {
  if (norm_left() == 0) return true;
  const double rounding =
      std::max(tolerances_.rounding_residual * now.force_scale, tolerances_.rounding_factor * residual_.rounding());
  const bool is_rounding = stalled && norm_left() <= rounding;
  const bool stands_still = now.iterations == 0 && now.residual <= residual_.rounding_of_positions() &&
                            residual_.each_body_within_rounding() && d.isZero(0);
  return is_rounding || stands_still;
}

void OpenClose::assemble(const Increment& d, double touching, Friction friction) {
  if (watch_) watch_(residual_.norm());
  residual_.assemble(d, touching, friction);
  residual_.measure_rounding();
}

void OpenClose::find_direction(const Increment& d, Friction friction) {
  const UnsymmetricBlocks& unsymmetric = friction == Friction::coupled ? residual_.unsymmetric() : nothing_;
  search_.pick_pending(residual_.gradient(), part_);
  if (elimination_.is_active()) {
    const Stopwatch watch(elimination_seconds_);
    elimination_.solve(residual_.matrix(), unsymmetric, part_, direction_);
  } else {
    negligible_in_system_.resize(residual_.systems());
    for (int s = 0; s < residual_.systems(); ++s)
      negligible_in_system_[s] = balances(s)
                                     ? std::numeric_limits<double>::infinity()
                                     : tolerances_.negligible_system * tolerance_ * residual_.force_scale_of_system(s);
    linear_.solve(residual_.matrix(), unsymmetric, part_, negligible_in_system_, direction_);
  }
  // A chip that flies off must not hold all others back. But with frozen friction the direction leads downhill, and is
  // sure to do so as a whole only.
  if (friction == Friction::coupled) residual_.keep_within_reach(direction_);
  part_ = -direction_;
  direction_ *= residual_.longest_step_fraction(d, part_);
}

void OpenClose::iterate(Increment& d, bool early) {
  const double before = norm_left();
  note_body_residuals();
  begin_search(d);
  start_ = d;
  advance_from_start(d, Friction::coupled);
  search_.keep(residual_.gradient(), direction_, [&](const PartwiseLineSearch::State& part) {
    const bool little_turned =
        part.slope_before < 0 && std::abs(part.slope) < -tolerances_.slope_turned * part.slope_before;
    return part.residual < std::max(tolerances_.reduced * part.residual_before, part.negligible) || little_turned;
  });
  if (!search_.any_pending() || full_increment_leads_on(d, before)) return;
  if (early && another_iteration_leads_on(d)) return;
  // The full increment leads astray. With friction frozen at this iterate there is a potential; it falls along the
  // direction, and its slope leads to its minimum. Often that lies in the narrow range in which a contact sticks, with
  // sliding one way before it and the other way behind it.
  search_.go_back(start_, d);
  residual_.evaluate(d, Friction::coupled);
  residual_.freeze(d);
  assemble(d, 0, Friction::frozen);
  find_direction(d, Friction::frozen);
  minimise_along_direction(d);
  residual_.evaluate(d, Friction::coupled);
}

void OpenClose::note_body_residuals() {
  if (!balances_alone_ || elimination_.is_active()) return;
  body_residuals_.resize(residual_.bodies());
  for (int b = 0; b < residual_.bodies(); ++b) body_residuals_[b] = residual_.norm_of_body(b);
}

bool OpenClose::full_increment_leads_on(Increment& d, double before) {
  if (!balances_alone_ || elimination_.is_active()) return false;
  const NonlinearElimination::Choice made_worse{.most = elimination_tolerances_.most_bodies,
                                                .worse_than = body_residuals_};
  if (!elimination_.begin(*composition_, residual_, made_worse)) return false;
  if (!trials_full_.is_due()) {
    elimination_.end(residual_);
    return false;
  }
  full_.start = start_;
  full_.end = d;
  full_.direction = direction_;
  full_.search = search_;
  const bool balanced = balance_picked(d, elimination_tolerances_.iterations_on_way);
  residual_.evaluate(d, Friction::coupled);
  const bool leads_on = balanced && norm_left() < tolerances_.reduced * before;
  trials_full_.note(leads_on);
  if (leads_on) return true;
  start_ = full_.start;
  d = full_.end;
  direction_ = full_.direction;
  search_ = full_.search;
  residual_.evaluate(d, Friction::coupled);
  return false;
}

bool OpenClose::another_iteration_leads_on(Increment& d) {
  second_start_ = start_;
  assemble(d, 0, Friction::coupled);
  find_direction(d, Friction::coupled);
  start_ = d;
  advance_from_start(d, Friction::coupled);
  start_ = second_start_;
  search_.keep(residual_.gradient(), direction_, [&](const PartwiseLineSearch::State& part) {
    return part.residual < tolerances_.reduced * part.residual_before;
  });
  return !search_.any_pending();
}

void OpenClose::begin_search(const Increment& d) {
  together_.reset(static_cast<int>(d.size() / 3));
  composition_->bodies->join_dof_blocks(together_);
  part_ = -direction_;
  if (composition_->shear) composition_->shear->join_with_strength(together_);
  for (const NormalContact* normal : composition_->normal) normal->join_touching(d, part_, together_);
  search_.set_parts(together_);
  find_negligible();
  search_.begin(residual_.gradient(), direction_, negligible_);
}

void OpenClose::advance_from_start(Increment& d, Friction friction) {
  search_.increment_along(direction_, scaled_);
  composition_->bodies->advance(start_, scaled_, d);
  residual_.evaluate(d, friction);
}

void OpenClose::minimise_along_direction(Increment& d) {
  begin_search(d);
  advance_from_start(d, Friction::frozen);
  for (int trial = 0; trial < tolerances_.line_search_limit; ++trial) {
    if (!search_.narrow(residual_.gradient(), direction_)) break;
    advance_from_start(d, Friction::frozen);
  }
}

void OpenClose::find_negligible() {
  const int blocks = static_cast<int>(direction_.size() / 3);
  negligible_.resize(blocks);
  for (int block = 0; block < blocks; ++block) {
    const int system = residual_.system_of(block);
    negligible_[block] = std::max(tolerances_.negligible_part * residual_.norm_of_system(system),
                                  tolerance_ * residual_.force_scale_of_system(system));
  }
}

bool OpenClose::converge_with_fallbacks(Increment& d, int limit, int& iterations, bool& interior_point_left) {
  const int left = limit - iterations - 1;
  if (!interior_point_left) {
    iterations += converge_with_frozen_friction(d, left);
    return true;
  }
  interior_point_left = false;
  d = begun_with_[elimination_.depth()];
  iterations += approach_by_interior_point(d, left);
  return !is_hopeless(limit - iterations);
}

int OpenClose::converge_with_frozen_friction(Increment& d, int limit) {
  double before = norm_left();
  int count = 0;
  residual_.freeze(d);
  for (; count < limit; ++count) {
    assemble(d, 0, Friction::frozen);
    search_.set_all_pending();
    find_direction(d, Friction::frozen);
    start_ = d;
    minimise_along_direction(d);
    const double rounding = tolerances_.rounding_factor * residual_.rounding();
    if (norm_left() > std::max(tolerances_.frozen_reduction * before, rounding)) continue;
    residual_.evaluate(d, Friction::coupled);
    before = norm_left();
    if (before <= rounding || coupled_iteration_leads_on(d)) return count;
    residual_.freeze(d);
  }
  residual_.evaluate(d, Friction::coupled);
  return count;
}

bool OpenClose::coupled_iteration_leads_on(Increment& d) {
  const double before = norm_left();
  assemble(d, 0, Friction::coupled);
  search_.set_all_pending();
  find_direction(d, Friction::coupled);
  begin_search(d);
  start_ = d;
  advance_from_start(d, Friction::coupled);
  search_.keep(residual_.gradient(), direction_, [&](const PartwiseLineSearch::State& part) {
    return part.residual < tolerances_.well_reduced * part.residual_before;
  });
  if (search_.any_pending()) {
    search_.go_back(start_, d);
    residual_.evaluate(d, Friction::coupled);
  }
  return norm_left() < tolerances_.well_reduced * before;
}

bool OpenClose::interior_point_applies() const {
  if (!composition_->links) return false;
  const ContactSet& contacts = composition_->links->contacts();
  if (contacts.loose.empty() || !contacts.bonded.empty()) return false;
  if (!elimination_.is_active()) return zero_.size() <= tolerances_.interior_point_unknowns;
  return 3 * elimination_.picked().dof_blocks.size() <= DenseSolver::largest_part;
}

int OpenClose::approach_by_interior_point(Increment& d, int limit) {
  const InteriorPoint::Problem problem{
      .bodies = *composition_->bodies,
      .links = *composition_->links,
      .pattern = residual_.matrix().pattern(),
      .picked = elimination_.is_active() ? &elimination_.picked() : nullptr,
      .arms = residual_.arms(),
      .add_gradient = [this](const Increment& at,
                             Eigen::VectorXd& sum) { residual_.add_gradient_without_contacts(at, sum); },
      .assemble = [this](
                      const Increment& at, SymmetricBlocks& matrix,
                      UnsymmetricBlocks& unsymmetric) { residual_.assemble_without_contacts(at, matrix, unsymmetric); },
      .longest_step_fraction =
          [this](const Increment& at, const Eigen::VectorXd& change) {
            return residual_.longest_step_fraction(at, change);
          },
      .is_near =
          [this](const Increment& at) {
            const double residual = residual_at(at);
            if (watch_) watch_(residual);
            return residual < tolerances_.interior_point_residual * residual_.force_scale();
          }};
  const int count = interior_.approach(problem, std::min(limit, tolerances_.interior_point_limit), d);
  residual_.evaluate(d, Friction::coupled);
  return count;
}

bool OpenClose::is_hopeless(int iterations_left) const {
  return residual_.norm() > tolerances_.hopeless_residual * residual_.force_scale() &&
         interior_.points() > iterations_left;
}

int OpenClose::worst_dof_block() const {
  if (residual_.gradient().size() == 0) return -1;
  Eigen::Index worst = 0;
  residual_.gradient().cwiseAbs().maxCoeff(&worst);
  return static_cast<int>(worst / 3);
}

}  // namespace talus
