#include "solve/equilibrium/interior_point.hpp"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.hpp"

namespace talus {

int InteriorPoint::approach(const Problem& problem, int limit, Increment& d) {
  if (matrix_.pattern().id() != problem.pattern.id()) {
    matrix_.set_pattern(problem.pattern);
    unsymmetric_.set_pattern(problem.pattern);
  }
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
  if (!factor(problem)) return false;
  right_ = -gradient_;
  solve_with_factor(problem);
  problem.bodies.advance(d, direction_, end_);
  const std::vector<int>& loose = problem.links.contacts().loose;
  contacts_.begin(problem.links, *problem.links.points_of(problem.picked, loose, picked_points_), d, direction_, end_,
                  gradient_.cwiseAbs().maxCoeff());
  return true;
}

bool InteriorPoint::factor(const Problem& problem) {
  const Stopwatch watch(times_.factor);
  if (problem.picked) {
    dense_.factor(matrix_, unsymmetric_.pairs(), problem.picked->dof_blocks);
    return true;
  }
  if (lu_.factor(matrix_, unsymmetric_.pairs())) return true;
  ++failed_factorisations_;
  return false;
}

void InteriorPoint::assemble_without_contacts(const Problem& problem, const Increment& d) {
  const Stopwatch watch(times_.assemble);
  gradient_.setZero(d.size());
  problem.add_gradient(d, gradient_);
  if (problem.picked) {
    right_.swap(gradient_);
    gradient_.setZero(d.size());
    for (const int block : problem.picked->dof_blocks) gradient_.segment<3>(3 * block) = right_.segment<3>(3 * block);
  }
  unsymmetric_.set_zero();
  problem.assemble(d, matrix_, unsymmetric_);
}

bool InteriorPoint::find_changes(const Problem& problem, const Increment& d) {
  {
    const Stopwatch watch(times_.assemble);
    contacts_.linearise(d);
    contacts_.add_tangent(d, problem.arms, unsymmetric_);
  }
  if (!factor(problem)) return false;
  const double complementarity = contacts_.mean_complementarity();
  contacts_.target_contact();
  solve(problem, d);
  const double left = std::pow(1 - contacts_.longest_step_fraction(), 3);  // Mehrotra's choice
  contacts_.target_complementarity(std::max(tolerances_.smallest_target, left) * complementarity);
  solve(problem, d);
  return direction_.allFinite();
}

void InteriorPoint::solve_with_factor(const Problem& problem) {
  if (!problem.picked) return lu_.solve(right_, direction_);
  const std::vector<int>& blocks = problem.picked->dof_blocks;
  picked_right_.resize(static_cast<Eigen::Index>(3 * blocks.size()));
  for (std::size_t k = 0; k < blocks.size(); ++k) picked_right_.segment<3>(3 * k) = right_.segment<3>(3 * blocks[k]);
  dense_.solve(picked_right_, picked_direction_);
  direction_.setZero(right_.size());
  for (std::size_t k = 0; k < blocks.size(); ++k)
    direction_.segment<3>(3 * blocks[k]) = picked_direction_.segment<3>(3 * k);
}

void InteriorPoint::solve(const Problem& problem, const Increment& d) {
  const Stopwatch watch(times_.solve);
  right_ = -gradient_;
  contacts_.add_forces(d, problem.arms, right_);
  solve_with_factor(problem);
  problem.bodies.advance(d, direction_, end_);
  contacts_.find_changes(d, end_);
}

}  // namespace talus
