#include "solve/equilibrium/partwise_line_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus {

void PartwiseLineSearch::set_size(int dof_blocks) {
  part_of_.assign(dof_blocks, 0);
  parts_.assign(1, {});
}

void PartwiseLineSearch::set_parts(DisjointSets& together) {
  int count = 0;
  for (int n = 0; n < together.size(); ++n) {  // the first of each set comes before its others
    const int first = together.first_of(n);
    part_of_[n] = first == n ? count++ : part_of_[first];
  }
  parts_.assign(count, {});
}

void PartwiseLineSearch::set_all_pending() {
  for (Part& part : parts_) part = {};
}

void PartwiseLineSearch::look(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction) {
  for (Part& part : parts_) part.state.residual = part.state.slope = 0;
  for (std::size_t n = 0; n < part_of_.size(); ++n) {
    State& state = parts_[part_of_[n]].state;
    const auto g = gradient.segment<3>(3 * n);
    state.residual += g.squaredNorm();
    state.slope -= g.dot(direction.segment<3>(3 * n));
  }
  for (Part& part : parts_) part.state.residual = std::sqrt(part.state.residual);
}

void PartwiseLineSearch::begin(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction,
                               std::span<const double> negligible) {
  look(gradient, direction);
  for (Part& part : parts_) {
    const State now = part.state;
    const bool pending = part.pending && now.slope != 0;
    part = {};
    part.pending = pending;
    part.state.residual_before = now.residual;
    part.state.slope_before = now.slope;
  }
  for (std::size_t n = 0; n < negligible.size(); ++n) parts_[part_of_[n]].state.negligible = negligible[n];
}

bool PartwiseLineSearch::any_pending() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.pending; });
}

void PartwiseLineSearch::pick_pending(const Eigen::VectorXd& gradient, Eigen::VectorXd& picked) const {
  picked = gradient;
  for (std::size_t n = 0; n < part_of_.size(); ++n)
    if (!parts_[part_of_[n]].pending) picked.segment<3>(3 * n).setZero();
}

void PartwiseLineSearch::increment_along(const Eigen::VectorXd& direction, Eigen::VectorXd& increment) const {
  increment.resize(direction.size());
  for (std::size_t n = 0; n < part_of_.size(); ++n)
    increment.segment<3>(3 * n) = -parts_[part_of_[n]].fraction * direction.segment<3>(3 * n);
}

void PartwiseLineSearch::go_back(Eigen::VectorXd& start, Eigen::VectorXd& d) const {
  for (std::size_t n = 0; n < part_of_.size(); ++n)
    if (parts_[part_of_[n]].pending)
      d.segment<3>(3 * n) = start.segment<3>(3 * n);
    else
      start.segment<3>(3 * n) = d.segment<3>(3 * n);
}

bool PartwiseLineSearch::narrow(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction) {
  keep(gradient, direction, [](const State& state) { return state.residual < state.negligible; });
  for (Part& part : parts_)
    if (part.pending) narrow(part);
  return any_pending();
}

void PartwiseLineSearch::narrow(Part& part) const {
  const double before = part.state.slope_before;
  const Point now{part.fraction, part.state.slope};
  if (part.at_full_increment) {
    part.at_full_increment = false;
    part.low = {0, before};
    part.high = now;
    part.pending = !(now.slope <= -tolerances_.overshot * before);
    if (part.pending) part.fraction = 0.5;
    return;
  }
  const double range = part.high.fraction - part.low.fraction;
  Point& side = now.slope > 0 ? part.high : part.low;
  const Point former = std::exchange(side, now);
  part.pending = std::abs(now.slope) > -tolerances_.flat_slope * before;
  if (!part.pending) return;
  // A contact that closes on the way makes the slope behind it larger by many orders of magnitude. On either side the
  // slope is nearly linear, so a secant through two fractions of one side finds the place where the contact closes; a
  // secant across both sides never would.
  const double root = now.fraction - now.slope * (now.fraction - former.fraction) / (now.slope - former.slope);
  const bool gains =
      part.high.fraction - part.low.fraction <= 0.5 * range || std::abs(now.slope) <= 0.5 * std::abs(former.slope);
  const bool is_between = part.low.fraction < root && root < part.high.fraction;
  part.fraction = gains && is_between ? root : 0.5 * (part.low.fraction + part.high.fraction);
}

}  // namespace talus
