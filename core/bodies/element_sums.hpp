#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/parallel.hpp"
#include "bodies/body_set.hpp"
#include "linear/symmetric_blocks.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// Sums over some elements of a set: each computed by itself, on several threads, then added up in their order, so that
/// no bit depends on how many threads there are.
class ElementSums {
 public:
  using Forces = std::array<Vec3, 4>;      ///< N, a corner
  using Stiffness = std::array<Mat3, 10>;  ///< N/m, lower triangle of the corners' blocks, row by row
  using WholeStiffness = std::array<std::array<Mat3, 4>, 4>;  ///< N/m, of the force on a corner by the way of another

  /// The block of a symmetric stiffness, of the force on corner a by the way of corner b.
  static Mat3 block(const Stiffness& stiffness, int a, int b) {
    return a >= b ? stiffness[a * (a + 1) / 2 + b] : Mat3(stiffness[b * (b + 1) / 2 + a].transpose());
  }

  static constexpr int grain = 64;  ///< elements, some 20 µs of work

  explicit ElementSums(const BodySet& set) : set_(set) {}

  /// Sum of energy_of(element) [J].
  template <class EnergyOf>
  double energy(const std::vector<int>& elements, const EnergyOf& energy_of) const {
    compute(elements, energy_of, energies_);
    double sum = 0;
    for (const double energy : energies_) sum += energy;
    return sum;
  }

  /// Adds forces_of(element), three numbers a corner [N].
  template <class ForcesOf>
  void add_gradient(const std::vector<int>& elements, const ForcesOf& forces_of, Eigen::VectorXd& sum) const {
    compute(elements, forces_of, forces_);
    for (std::size_t i = 0; i < elements.size(); ++i)
      for (int a = 0; a < 4; ++a) sum.segment<3>(3 * set_.elements[elements[i]].dof_blocks[a]) += forces_[i][a];
  }

  /// Adds stiffness_of(element), a 3×3 block a pair of corners [N/m].
  template <class StiffnessOf>
  void add_hessian(const std::vector<int>& elements, const StiffnessOf& stiffness_of, SymmetricBlocks& sum) const {
    compute(elements, stiffness_of, stiffness_);
    add_known_hessian(
        elements, [this](std::size_t i) -> const Stiffness& { return stiffness_[i]; }, sum);
  }

  /// Adds the stiffness of the elements, which `known` has by their places in the list [N/m].
  template <class Known>
  void add_known_hessian(const std::vector<int>& elements, const Known& known, SymmetricBlocks& sum) const {
    find_slots(elements, sum.pattern());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const std::array<int, 4>& dof_blocks = set_.elements[elements[i]].dof_blocks;
      const Stiffness& stiffness = known(i);
      for (int a = 0, k = 0; a < 4; ++a)
        for (int b = 0; b <= a; ++b, ++k) sum.add_at(slots_[i][k], dof_blocks[a], dof_blocks[b], stiffness[k]);
    }
  }

  /// Adds stiffness_of(element), unsymmetric [N/m].
  template <class StiffnessOf>
  void add_unsymmetric(const std::vector<int>& elements, const StiffnessOf& stiffness_of,
                       UnsymmetricBlocks& sum) const {
    compute(elements, stiffness_of, whole_);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const std::array<int, 4>& dof_blocks = set_.elements[elements[i]].dof_blocks;
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) sum.add(dof_blocks[a], dof_blocks[b], whole_[i][a][b]);
    }
  }

 private:
  template <class Of, class Value>
  void compute(const std::vector<int>& elements, const Of& of, std::vector<Value>& values) const {
    values.resize(elements.size());
    in_parallel(static_cast<int>(elements.size()), grain, [&](int first, int last) {
      for (int i = first; i < last; ++i) values[i] = of(elements[i]);
    });
  }

  /// Where the pattern has the pairs of each element's corners. Elements that move or rest get other unknowns, and the
  /// matrix another pattern.
  void find_slots(const std::vector<int>& elements, const BlockPattern& pattern) const {
    if (pattern.id() == pattern_ && slots_.size() == elements.size()) return;
    pattern_ = pattern.id();
    slots_.resize(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const std::array<int, 4>& dof_blocks = set_.elements[elements[i]].dof_blocks;
      for (int a = 0, k = 0; a < 4; ++a)
        for (int b = 0; b <= a; ++b, ++k) slots_[i][k] = pattern.slot(dof_blocks[a], dof_blocks[b]);
    }
  }

  const BodySet& set_;
  mutable std::uint64_t pattern_ = 0;  ///< that slots_ are of
  mutable std::vector<std::array<int, 10>> slots_;
  mutable std::vector<double> energies_;
  mutable std::vector<Forces> forces_;
  mutable std::vector<Stiffness> stiffness_;
  mutable std::vector<WholeStiffness> whole_;
};

}  // namespace talus
