#include "solve/equilibrium/interior_point.hpp"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.hpp"

namespace talus {

int InteriorPoint::approach(const Problem& problem, int limit, Increment& d) {
  matrix_.set_pattern(problem.pattern);
  unsymmetric_.set_pattern(problem.pattern);
  contacts_.clear();
  if (!begin(problem, d)) return 0;
  int count = 0, short_ones = 0;
  for (; count < limit && short_ones < tolerances_.short_iterations && !problem.is_near(d); ++count) {
    if (count > 0) assemble_without_contacts(problem, d);
    if (!find_changes(problem, d)) break;
    const double fraction = std::min(contacts_.longest_step_fraction(), problem.longest_step_fraction(d, direction_));
    start_ = d;
    direction_ *= fraction;
    problem.bodies.advance(start_, direction_, d);
    contacts_.change_by(fraction);
    short_ones = fraction < tolerances_.short_fraction ? short_ones + 1 : 0;
  }
  return count;
}

bool InteriorPoint::begin(const Problem& problem, const Increment& d) {
  assemble_without_contacts(problem, d);
  if (!factor()) return false;
  right_ = -gradient_;
  lu_.solve(right_, direction_);
  problem.bodies.advance(d, direction_, end_);
  contacts_.begin(problem.links, d, direction_, end_, gradient_.cwiseAbs().maxCoeff());
  return true;
}

bool InteriorPoint::factor() {
  const Stopwatch watch(times_.factor);
  if (lu_.factor(matrix_, unsymmetric_.pairs())) return true;
  ++failed_factorisations_;
  return false;
}

void InteriorPoint::assemble_without_contacts(const Problem& problem, const Increment& d) {
  const Stopwatch watch(times_.assemble);
  gradient_.setZero(d.size());
  problem.add_gradient(d, gradient_);
  unsymmetric_.set_zero();
  problem.assemble(d, matrix_, unsymmetric_);
}

bool InteriorPoint::find_changes(const Problem& problem, const Increment& d) {
  {
    const Stopwatch watch(times_.assemble);
    contacts_.linearise(d);
    contacts_.add_tangent(d, problem.arms, unsymmetric_);
  }
  if (!factor()) return false;
  const double complementarity = contacts_.mean_complementarity();
  contacts_.target_contact();
  solve(problem, d);
  const double left = std::pow(1 - contacts_.longest_step_fraction(), 3);  // Mehrotra's choice
  contacts_.target_complementarity(std::max(tolerances_.smallest_target, left) * complementarity);
  solve(problem, d);
  return direction_.allFinite();
}

void InteriorPoint::solve(const Problem& problem, const Increment& d) {
  const Stopwatch watch(times_.solve);
  right_ = -gradient_;
  contacts_.add_forces(d, problem.arms, right_);
  lu_.solve(right_, direction_);
  problem.bodies.advance(d, direction_, end_);
  contacts_.find_changes(d, end_);
}

}  // namespace talus
