#include "solve/equilibrium/nonlinear_elimination.hpp"

#include <algorithm>
#include <span>

namespace talus {

bool NonlinearElimination::begin(const Composition& composition, StepResidual& residual, const Choice& choice) {
  if (!composition.links) return false;
  if (subsets_.size() == static_cast<std::size_t>(depth_)) subsets_.emplace_back();
  Subset& subset = subsets_[depth_];
  if (!pick_bodies(composition, residual, choice, subset.picked)) return false;
  split(residual.matrix().pattern(), subset);
  ++depth_;
  residual.look_at(&subset.picked);
  return true;
}

void NonlinearElimination::end(StepResidual& residual) {
  --depth_;
  residual.look_at(is_active() ? &picked() : nullptr);
}

bool NonlinearElimination::pick_bodies(const Composition& composition, const StepResidual& residual,
                                       const Choice& choice, PickedBodies& picked) {
  const BodySet& set = *composition.bodies;
  residual.list_unbalanced(tolerances_.unbalanced, picked.places);
  if (!choice.worse_than.empty())
    std::erase_if(picked.places, [&](int b) { return residual.norm_of_body(b) <= choice.worse_than[b]; });
  const int looked_at = residual.bodies_looked_at();
  auto most = static_cast<std::size_t>(choice.most * looked_at);
  if (is_active()) most = std::min(most, static_cast<std::size_t>(looked_at - 1));  // else it would go on for ever
  if (picked.places.empty() || picked.places.size() > most) return false;
  picked.has.assign(set.bodies.size(), 0);
  for (const int b : picked.places) picked.has[set.moving[b]] = 1;
  for (int away = 0; away < choice.contacts_away && pick_neighbours(composition, most, picked); ++away) continue;
  picked.places.clear();
  picked.dof_blocks.clear();
  picked.turning.clear();
  for (int b = 0; b < residual.bodies(); ++b) {
    if (!picked.has[set.moving[b]]) continue;
    picked.places.push_back(b);
    const auto [first, end] = residual.dof_blocks_of(b);
    for (int block = first; block < end; ++block) picked.dof_blocks.push_back(block);
  }
  for (const int r : set.turning)
    if (picked.has[set.rigid[r].body]) picked.turning.push_back(r);
  return true;
}

bool NonlinearElimination::pick_neighbours(const Composition& composition, std::size_t most, PickedBodies& picked) {
  const std::vector<int>& moving = composition.bodies->moving;
  touches_picked_ = picked.has;
  for (const ContactPoint& point : composition.links->contacts().points)
    if (picked.has[point.bodies[0]] != picked.has[point.bodies[1]])
      for (const int b : point.bodies) touches_picked_[b] = 1;
  const auto count = std::count_if(moving.begin(), moving.end(), [this](int b) { return touches_picked_[b] != 0; });
  if (static_cast<std::size_t>(count) > most) return false;
  for (const int b : moving) picked.has[b] = touches_picked_[b];
  return true;
}

/// Bodies that touch none of the others have equations of their own.
void NonlinearElimination::split(const BlockPattern& pattern, Subset& subset) {
  const std::vector<int>& dof_blocks = subset.picked.dof_blocks;
  number_.resize(pattern.nodes(), -1);
  for (std::size_t k = 0; k < dof_blocks.size(); ++k) number_[dof_blocks[k]] = static_cast<int>(k);
  together_.reset(static_cast<int>(dof_blocks.size()));
  for (const int column : dof_blocks)
    for (int slot = pattern.column_begin()[column]; slot < pattern.column_begin()[column + 1]; ++slot)
      if (const int row = number_[pattern.rows()[slot]]; row >= 0) together_.join(number_[column], row);
  for (const int block : dof_blocks) number_[block] = -1;
  by_system_.clear();
  for (int k = 0; k < static_cast<int>(dof_blocks.size()); ++k)
    by_system_.emplace_back(together_.first_of(k), dof_blocks[k]);
  std::sort(by_system_.begin(), by_system_.end());
  subset.grouped.clear();
  subset.system_ends.clear();
  for (std::size_t i = 0; i < by_system_.size(); ++i) {
    if (i > 0 && by_system_[i].first != by_system_[i - 1].first) subset.system_ends.push_back(i);
    subset.grouped.push_back(by_system_[i].second);
  }
  subset.system_ends.push_back(subset.grouped.size());
}

void NonlinearElimination::solve(const SymmetricBlocks& matrix, const UnsymmetricBlocks& unsymmetric,
                                 const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  x.setZero(b.size());
  const Subset& subset = subsets_[depth_ - 1];
  std::size_t begin = 0;
  for (const std::size_t end : subset.system_ends) {
    const std::span<const int> system(subset.grouped.data() + begin, end - begin);
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
