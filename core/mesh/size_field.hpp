#pragma once

#include <Eigen/Geometry>
#include <span>

#include "model/rock/blocks.hpp"

namespace talus {

/// Around the point or the face that a refinement is near, without its reach.
Eigen::AlignedBox3d box_of(const MeshRefinement& refinement);

/// m, that edges aim at in a point of a block whose own size is `own`: within a refinement's radius its size, from
/// there to twice the radius growing in proportion to the distance to the block's own. Where several reach the point
/// the smallest holds.
double size_at(const Vec3& point, double own, std::span<const MeshRefinement> refinements);

/// m, the largest that edges aim at anywhere in a block.
double largest_size(double own, std::span<const MeshRefinement> refinements);

}  // namespace talus
