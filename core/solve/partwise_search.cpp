#include "solve/partwise_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus {

namespace {

/// A full step whose slope turns round by more than this share is shortened …
constexpr double overstepped = 0.5;
/// … until the slope is down to this share.
constexpr double flat = 0.1;

}  // namespace

void PartwiseSearch::set_size(int freedoms) {
  part_of_.assign(freedoms, 0);
  parts_.assign(1, {});
}

void PartwiseSearch::set_parts(DisjointSets& together) {
  int count = 0;
  for (int n = 0; n < together.size(); ++n) {  // the first of each set comes before its others
    const int first = together.first_of(n);
    part_of_[n] = first == n ? count++ : part_of_[first];
  }
  parts_.assign(count, {});
}

void PartwiseSearch::take_all() {
  for (Part& part : parts_) part = {};
}

void PartwiseSearch::look(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction) {
  for (Part& part : parts_) part.state.residual = part.state.slope = 0;
  for (std::size_t n = 0; n < part_of_.size(); ++n) {
    State& state = parts_[part_of_[n]].state;
    const auto g = gradient.segment<3>(3 * n);
    state.residual += g.squaredNorm();
    state.slope -= g.dot(direction.segment<3>(3 * n));
  }
  for (Part& part : parts_) part.state.residual = std::sqrt(part.state.residual);
}

void PartwiseSearch::begin(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction) {
  look(gradient, direction);
  for (Part& part : parts_) {
    const State now = part.state;
    const bool pending = part.pending && now.slope != 0;
    part = {};
    part.pending = pending;
    part.state.residual_before = now.residual;
    part.state.slope_before = now.slope;
  }
}

bool PartwiseSearch::any_pending() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.pending; });
}

void PartwiseSearch::pick_pending(const Eigen::VectorXd& gradient, Eigen::VectorXd& picked) const {
  picked = gradient;
  for (std::size_t n = 0; n < part_of_.size(); ++n)
    if (!parts_[part_of_[n]].pending) picked.segment<3>(3 * n).setZero();
}

void PartwiseSearch::step_along(const Eigen::VectorXd& direction, Eigen::VectorXd& step) const {
  step.resize(direction.size());
  for (std::size_t n = 0; n < part_of_.size(); ++n)
    step.segment<3>(3 * n) = -parts_[part_of_[n]].share * direction.segment<3>(3 * n);
}

void PartwiseSearch::go_back(Eigen::VectorXd& start, Eigen::VectorXd& d) const {
  for (std::size_t n = 0; n < part_of_.size(); ++n)
    if (parts_[part_of_[n]].pending)
      d.segment<3>(3 * n) = start.segment<3>(3 * n);
    else
      start.segment<3>(3 * n) = d.segment<3>(3 * n);
}

bool PartwiseSearch::narrow(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction, double slight) {
  leave(gradient, direction, [slight](const State& state) { return state.residual < slight; });
  for (Part& part : parts_)
    if (part.pending) narrow(part);
  return any_pending();
}

void PartwiseSearch::narrow(Part& part) {
  const double before = part.state.slope_before;
  const Point now{part.share, part.state.slope};
  if (part.at_full_step) {
    part.at_full_step = false;
    part.low = {0, before};
    part.high = now;
    part.pending = !(now.slope <= -overstepped * before);
    if (part.pending) part.share = 0.5;
    return;
  }
  const double range = part.high.share - part.low.share;
  Point& side = now.slope > 0 ? part.high : part.low;
  const Point former = std::exchange(side, now);
  part.pending = std::abs(now.slope) > -flat * before;
  if (!part.pending) return;
  // A contact that closes on the way makes the slope behind it larger by many orders. There the slope is all but a
  // line: one through two shares of the same side leads to where it starts, which one through both sides never would.
  const double root = now.share - now.slope * (now.share - former.share) / (now.slope - former.slope);
  const bool gains =
      part.high.share - part.low.share <= 0.5 * range || std::abs(now.slope) <= 0.5 * std::abs(former.slope);
  const bool is_between = part.low.share < root && root < part.high.share;
  part.share = gains && is_between ? root : 0.5 * (part.low.share + part.high.share);
}

}  // namespace talus
