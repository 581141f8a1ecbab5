#include "solve/equilibrium/nonlinear_elimination.hpp"

#include <algorithm>
#include <span>

namespace talus {

bool NonlinearElimination::begin(const Composition& composition, StepResidual& residual, double most,
                                 int contacts_away) {
  if (!composition.links) return false;
  if (!pick_bodies(*composition.bodies, composition.links->contacts(), residual, most, contacts_away)) return false;
  split(residual.matrix().pattern());
  residual.look_at(&picked_);
  return true;
}

void NonlinearElimination::end(StepResidual& residual) {
  picked_.dof_blocks.clear();
  residual.look_at(nullptr);
}

bool NonlinearElimination::pick_bodies(const BodySet& set, const ContactSet& contacts, const StepResidual& residual,
                                       double most, int contacts_away) {
  residual.list_unbalanced(tolerances_.unbalanced, picked_.places);
  const auto most_bodies = static_cast<std::size_t>(most * residual.bodies());
  if (picked_.places.empty() || picked_.places.size() > most_bodies) return false;
  picked_.has.assign(set.bodies.size(), 0);
  for (const int b : picked_.places) picked_.has[set.moving[b]] = 1;
  for (int away = 0; away < contacts_away && pick_neighbours(set, contacts, most_bodies); ++away) continue;
  picked_.places.clear();
  picked_.turning.clear();
  for (int b = 0; b < residual.bodies(); ++b) {
    if (!picked_.has[set.moving[b]]) continue;
    picked_.places.push_back(b);
    const auto [first, end] = residual.dof_blocks_of(b);
    for (int block = first; block < end; ++block) picked_.dof_blocks.push_back(block);
  }
  for (const int r : set.turning)
    if (picked_.has[set.rigid[r].body]) picked_.turning.push_back(r);
  return true;
}

bool NonlinearElimination::pick_neighbours(const BodySet& set, const ContactSet& contacts, std::size_t most) {
  touches_picked_ = picked_.has;
  for (const ContactPoint& point : contacts.points)
    if (picked_.has[point.bodies[0]] != picked_.has[point.bodies[1]])
      for (const int b : point.bodies) touches_picked_[b] = 1;
  const auto count =
      std::count_if(set.moving.begin(), set.moving.end(), [this](int b) { return touches_picked_[b] != 0; });
  if (static_cast<std::size_t>(count) > most) return false;
  for (const int b : set.moving) picked_.has[b] = touches_picked_[b];
  return true;
}

/// Bodies that touch none of the others have equations of their own.
void NonlinearElimination::split(const BlockPattern& pattern) {
  number_.resize(pattern.nodes(), -1);
  for (std::size_t k = 0; k < picked_.dof_blocks.size(); ++k) number_[picked_.dof_blocks[k]] = static_cast<int>(k);
  together_.reset(static_cast<int>(picked_.dof_blocks.size()));
  for (const int column : picked_.dof_blocks)
    for (int slot = pattern.column_begin()[column]; slot < pattern.column_begin()[column + 1]; ++slot)
      if (const int row = number_[pattern.rows()[slot]]; row >= 0) together_.join(number_[column], row);
  for (const int block : picked_.dof_blocks) number_[block] = -1;
  by_system_.clear();
  for (int k = 0; k < static_cast<int>(picked_.dof_blocks.size()); ++k)
    by_system_.emplace_back(together_.first_of(k), picked_.dof_blocks[k]);
  std::sort(by_system_.begin(), by_system_.end());
  grouped_.clear();
  system_ends_.clear();
  for (std::size_t i = 0; i < by_system_.size(); ++i) {
    if (i > 0 && by_system_[i].first != by_system_[i - 1].first) system_ends_.push_back(i);
    grouped_.push_back(by_system_[i].second);
  }
  system_ends_.push_back(grouped_.size());
}

void NonlinearElimination::solve(const SymmetricBlocks& matrix, const UnsymmetricBlocks& unsymmetric,
                                 const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  x.setZero(b.size());
  std::size_t begin = 0;
  for (const std::size_t end : system_ends_) {
    const std::span<const int> system(grouped_.data() + begin, end - begin);
    begin = end;
    right_.resize(static_cast<Eigen::Index>(3 * system.size()));
    for (std::size_t k = 0; k < system.size(); ++k) right_.segment<3>(3 * k) = b.segment<3>(3 * system[k]);
    if (3 * system.size() <= DenseSolver::largest_part) {
      dense_.factor(matrix, unsymmetric.pairs(), system);
      dense_.solve(right_, solution_);
    } else {
      sparse_.take(matrix, unsymmetric.pairs(), system);
      sparse_.solve(right_, linear_, work_, solution_);
    }
    for (std::size_t k = 0; k < system.size(); ++k) x.segment<3>(3 * system[k]) = solution_.segment<3>(3 * k);
  }
}

}  // namespace talus
