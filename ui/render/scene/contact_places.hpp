#pragma once

#include <vector>

#include "results/frame.hpp"

namespace talus {

struct BlockSystem;

/// Where the contact points of a frame are drawn when its displacements are drawn `scale` times as large: each goes
/// with the faces of its two blocks, and lies midway where these are drawn apart. m, in the order of Frame::contacts.
std::vector<Vec3> contact_places(const BlockSystem& system, const Frame& frame, double scale);

}  // namespace talus
