#pragma once

#include "mesh/block.hpp"

namespace talus {

/// The block whose surface lies against that of another one at `point`, a place of its surface with the outward unit
/// `normal`; −1 where none does. Faces lie against each other where their normals are opposite to 1° and they are no
/// farther apart than 1e-6 of the other block's size.
int block_against(const BlockSystem& system, int block, const Vec3& point, const Vec3& normal);

}  // namespace talus
