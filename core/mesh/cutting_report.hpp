#pragma once

#include <string>

#include "base/vector.hpp"

namespace talus {

/// A piece that cutting left too thin to be a block.
struct Splinter {
  /// What became of it: nothing yet, for the blocks are refused; it is left out; or it is part of a neighbour.
  enum class Fate { refused, dropped, merged };

  int solid = 0;              ///< index into Project::solids
  Vec3 where = Vec3::Zero();  ///< m, its centroid
  double volume = 0;          ///< m³
  double thickness = 0;       ///< m, twice its volume over its surface
  Fate fate = Fate::refused;
  std::string merged_into;  ///< name of the block that it is part of
};

/// A cut with joints that end, and how many of them divide rock; the others end inside a block and are left out.
struct EndingJoints {
  int cut = 0;       ///< index into Project::cuts
  int joints = 0;    ///< discs, polygons, or planes that end at others
  int dividing = 0;  ///< that have a block on either side somewhere
};

}  // namespace talus
