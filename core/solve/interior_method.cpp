#include "solve/interior_method.hpp"

#include <algorithm>
#include <cmath>

#include "solve/stopwatch.hpp"

namespace talus {

namespace {

/// No iteration aims at less of the mean product that there is.
constexpr double least_aim = 1e-4;
/// Of a step: so many that are shorter, one after the other, lead nowhere.
constexpr double short_share = 1e-2;
constexpr int shorts = 4;

}  // namespace

int InteriorMethod::approach(const Step& step, int limit, Increment& d) {
  matrix_.set_pattern(step.pattern);
  beyond_.set_pattern(step.pattern);
  contacts_.clear();
  if (!begin(step, d)) return 0;
  int count = 0, short_ones = 0;
  for (; count < limit && short_ones < shorts && !step.is_near(d); ++count) {
    if (count > 0) find_rest(step, d);
    if (!find_changes(step, d)) break;
    const double share = std::min(contacts_.longest_share(), step.longest_share(d, direction_));
    start_ = d;
    direction_ *= share;
    step.bodies.advance(start_, direction_, d);
    contacts_.change_by(share);
    short_ones = share < short_share ? short_ones + 1 : 0;
  }
  return count;
}

bool InteriorMethod::begin(const Step& step, const Increment& d) {
  find_rest(step, d);
  const Stopwatch watch(times_.factor);
  if (!lu_.factor(matrix_, beyond_.pairs())) return false;
  right_ = -rest_;
  lu_.solve(right_, direction_);
  contacts_.begin(step.links, d, direction_, rest_.cwiseAbs().maxCoeff());
  return true;
}

void InteriorMethod::find_rest(const Step& step, const Increment& d) {
  const Stopwatch watch(times_.assemble);
  rest_.setZero(d.size());
  step.add_gradient(d, rest_);
  beyond_.set_zero();
  step.assemble(d, matrix_, beyond_);
}

bool InteriorMethod::find_changes(const Step& step, const Increment& d) {
  {
    const Stopwatch watch(times_.assemble);
    contacts_.linearise(d);
    contacts_.add_tangent(d, beyond_);
  }
  {
    const Stopwatch watch(times_.factor);
    if (!lu_.factor(matrix_, beyond_.pairs())) return false;
  }
  const double product = contacts_.mean_product();
  contacts_.aim_at_contact();
  solve(step, d);
  contacts_.aim_at(std::max(least_aim, std::pow(1 - contacts_.longest_share(), 3)) * product);
  solve(step, d);
  return direction_.allFinite();
}

void InteriorMethod::solve(const Step& step, const Increment& d) {
  const Stopwatch watch(times_.solve);
  right_ = -rest_;
  contacts_.add_forces(d, right_);
  lu_.solve(right_, direction_);
  step.bodies.advance(d, direction_, end_);
  contacts_.find_changes(d, end_);
}

}  // namespace talus
