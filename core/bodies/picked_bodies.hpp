#pragma once

#include <vector>

#include "bodies/body_set.hpp"

namespace talus {

/// Some of the moving bodies, which are looked at alone while all others are held.
struct PickedBodies {
  std::vector<int> places;      ///< in BodySet::moving, ascending
  std::vector<int> dof_blocks;  ///< ascending
  std::vector<int> turning;     ///< those of BodySet::turning, ascending
  std::vector<char> has;        ///< a body: whether it is one of them

  /// Those of a force law that turn: all, or of these.
  static const std::vector<int>& turning_of(const PickedBodies* picked, const BodySet& set) {
    return picked ? picked->turning : set.turning;
  }
};

}  // namespace talus
