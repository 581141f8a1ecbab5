#pragma once

#include <array>
#include <span>
#include <vector>

#include "render/scene/surface_tree.hpp"

namespace talus {

/// About the same surface with fewer triangles, for what is drawn many times over: points are left out one by one, each
/// drawn to a neighbour, where that moves the surface least (by quadrics of the planes around, Garland & Heckbert 1997)
/// until `most` triangles are left, or leaving out more would move it by more than 1/200 of its size. Those that are
/// left are points of `rock`; a closed surface stays closed. One that has no more than `most` comes back as it is.
std::vector<std::array<int, 3>> thinned(const RockSurface& rock, std::size_t most);

}  // namespace talus
