#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/found_point.hpp"

namespace talus {

/// Plans which nodes contacts may couple: those of their stencils, and the nodes around them on the same smooth faces,
/// where the contacts may slide to. A single body (rigid or affine) has one handle for all its nodes. The plan stays
/// until a contact needs a pair that it lacks, or two bodies have parted.
class Coupling {
 public:
  explicit Coupling(const ContactFeatures& features) : features_(features), rows_(features.node_count()) {}

  /// Makes sure that the plan holds what these points couple.
  void cover(const FoundPoints& found);

  /// Forgets the plan: other nodes may move.
  void clear();
  /// Forgets the pairs with nodes that may not move any more.
  void drop_immovable();

  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }
  std::uint64_t generation() const { return generation_; }

  void archive(auto& state) {
    if (state.reads()) forget_rows();
    state(pairs_, planned_, kept_, generation_);
    if (state.reads()) index_rows();
  }

 private:
  bool holds(int i, int j) const;
  bool holds(const FoundPoints& found);
  bool couples(const FoundPoints& found, const FoundPoint& point) const;
  bool some_parted(const FoundPoints& found);
  void plan_bodies(const FoundPoints& found);
  void widen(std::span<const int> nodes, int smooth_face, std::vector<int>& widened) const;
  void forget_rows();
  void index_rows();

  struct Row {
    int begin = 0, end = 0;
  };
  const ContactFeatures& features_;
  std::vector<std::pair<int, int>> pairs_;    // sorted
  std::vector<Row> rows_;                     // a node: the pairs that it is the first of
  std::vector<std::pair<int, int>> planned_;  // pairs of movable bodies of the plan, sorted
  std::vector<char> touch_;                   // such a pair
  std::vector<int> around_;                   // handles of a point's stencil, also beside it
  int kept_ = 0;                              // times that the plan has been kept since bodies were compared
  std::uint64_t generation_ = 0;
};

}  // namespace talus
