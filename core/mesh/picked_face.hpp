#pragma once

#include <vector>

#include "mesh/block.hpp"

namespace talus {

/// A flat face of a block that a point was picked on.
struct PickedFace {
  double area = 0;               ///< m²
  Vec3 centroid = Vec3::Zero();  ///< m
  Vec3 normal = Vec3::UnitZ();   ///< unit, outwards
  std::vector<Vec3> corners;     ///< m, where its outlines bend, in no order
  std::vector<Vec3> outline;     ///< m, the corners round all of it, counter-clockwise seen from outside
};

/// The triangles of the block's surface that lie in the plane through `point` across `normal` (unit, outwards), to a
/// thousandth of a radian and a millionth of the block's size. No area where there are none.
PickedFace face_at(const Block& block, const Vec3& point, const Vec3& normal);

}  // namespace talus
