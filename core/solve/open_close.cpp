#include "solve/open_close.hpp"

#include <algorithm>
#include <cmath>

#include "solve/stopwatch.hpp"

namespace talus {

namespace {

/// Internal forces of stressed rock cancel in equilibrium: round-off in them must not count as imbalance, nor may their
/// size hide one.
constexpr double internal_share = 1e-3;
/// The same for the change of momentum that a free flight would need: M·2V/Δ.
constexpr double momentum_share = 1e-6;

bool internal(const Effect& effect) { return effect.name() == "elasticity" || effect.name() == "initial stress"; }

}  // namespace

OpenClose::OpenClose(Composition& composition, OpenCloseSettings settings)
    : composition_(composition), settings_(settings) {
  times_.effects.assign(composition.effects.size(), 0);
}

void OpenClose::set_pattern(int nodes, std::vector<std::pair<int, int>> couplings) {
  const Stopwatch watch(times_.factor);
  for (const auto& effect : composition_.effects) effect->add_couplings(couplings);
  constant_.set_pattern(nodes, couplings);
  matrix_.set_pattern(nodes, std::move(couplings));
  cholesky_.analyse(matrix_);
}

void OpenClose::begin_step() {
  const Stopwatch watch(times_.assemble);
  constant_.set_zero();
  const Increment none = Increment::Zero(3 * constant_.nodes());
  part_.resize(none.size());
  momentum_scale_ = 0;
  for (std::size_t i = 0; i < composition_.effects.size(); ++i) {
    const Stopwatch share(times_.effects[i]);
    const Effect& effect = *composition_.effects[i];
    if (effect.quadratic()) effect.add_hessian(none, constant_);
    if (effect.name() != "inertia") continue;
    part_.setZero();
    effect.add_gradient(none, part_);
    momentum_scale_ = momentum_share * part_.norm();
  }
}

void OpenClose::evaluate(const Increment& d) {
  const Stopwatch watch(times_.update);
  gradient_.setZero(d.size());
  part_.resize(d.size());
  force_scale_ = momentum_scale_;
  for (std::size_t i = 0; i < composition_.effects.size(); ++i) {
    const Stopwatch share(times_.effects[i]);
    const Effect& effect = *composition_.effects[i];
    part_.setZero();
    effect.add_gradient(d, part_);
    gradient_ += part_;
    force_scale_ = std::max(force_scale_, (internal(effect) ? internal_share : 1.0) * part_.norm());
  }
}

double OpenClose::residual_at(const Increment& d) {
  if (composition_.shear) composition_.shear->update_strength(d);
  evaluate(d);
  return gradient_.norm();
}

void OpenClose::assemble(const Increment& d) {
  const Stopwatch watch(times_.assemble);
  matrix_.assign(constant_);
  for (std::size_t i = 0; i < composition_.effects.size(); ++i) {
    const Stopwatch share(times_.effects[i]);
    if (!composition_.effects[i]->quadratic()) composition_.effects[i]->add_hessian(d, matrix_);
  }
}

void OpenClose::move(Increment& d) {
  const double slope_before = gradient_.dot(step_);  // negative: the matrix is positive definite
  const Increment start = d;
  double share = 1;
  for (int k = 0;; ++k) {
    d = start + share * step_;
    if (k == settings_.shortenings) return;
    evaluate(d);
    const double slope = gradient_.dot(step_);
    if (!(slope > -settings_.overshoot * slope_before)) return;  // the valley's floor lies ahead or near
    share *= slope_before / (slope_before - slope);
  }
}

Settling OpenClose::settle(Increment& d) {
  Settling result;
  double best = 1e300;
  for (;; ++result.iterations) {
    result.residual = residual_at(d);
    result.force_scale = force_scale_;
    if (!std::isfinite(result.residual)) return result;
    const bool stalled =
        result.iterations > 2 && result.residual > 0.5 * best && result.residual <= settings_.round_off * force_scale_;
    result.settled = result.residual <= settings_.tolerance * force_scale_ || stalled;
    if (result.settled || result.iterations >= settings_.iteration_limit) break;
    best = std::min(best, result.residual);
    assemble(d);
    {
      const Stopwatch watch(times_.factor);
      cholesky_.factor(matrix_);
    }
    {
      const Stopwatch watch(times_.solve);
      cholesky_.solve(-gradient_, step_);
    }
    move(d);
  }
  if (!result.settled && gradient_.size() > 0) {
    Eigen::Index worst = 0;
    gradient_.cwiseAbs().maxCoeff(&worst);
    result.worst_node = static_cast<int>(worst / 3);
  }
  return result;
}

}  // namespace talus
