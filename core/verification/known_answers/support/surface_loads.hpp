#pragma once

#include <functional>

#include "verification/known_answers/support/scene.hpp"

namespace talus {

/// Traction [Pa] at a place [m] of a surface with an outward unit normal.
using Traction = std::function<Vec3(const Vec3& place, const Vec3& normal)>;

/// Dead loads on the surface nodes of a block that do the same work as a traction: each triangle takes the traction at
/// its centre and gives a third to each corner, which is exact for a uniform one. Nodes without load are left out.
std::vector<PointLoad> surface_loads(const Block& block, const Traction& traction);

/// Constraints of the six rigid motions and of nothing else, at three points that do not lie on a line [m].
std::vector<Constraint> held_in_place(const std::string& block, const Vec3& origin, const Vec3& along_x,
                                      const Vec3& along_y);

}  // namespace talus
