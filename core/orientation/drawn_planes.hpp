#pragma once

#include <vector>

#include "model/project.hpp"

namespace talus {

/// The single planes of a cut in order along its upward normal, without spacing or count. Where it has a law of spacing
/// or a scatter, they are drawn with its seed: the same on every machine, since what is drawn is rounded to 1e-6 m and
/// 1e-6 degrees, far above the last bits in which libraries differ. The first one goes through `through`; a plane is
/// turned about the point at which it crosses the normal through there.
std::vector<Cut> single_planes(const Cut& cut);

/// Whether chance has a part in it.
bool is_drawn(const Cut& cut);

}  // namespace talus
