#pragma once

#include <vector>

#include "model/project.hpp"
#include "orientation/attitude.hpp"

namespace talus {

/// The single joints of a cut, without spacing or count: planes in order along its upward normal, each with the disc or
/// the polygon that makes it end moved along, or the discs of a network. Where it has a law of spacing or a scatter,
/// they are drawn with its seed: the same on every machine, since what is drawn is rounded to 1e-6 m and 1e-6 degrees,
/// far above the last bits in which libraries differ. The first one goes through `through`; a plane is turned about the
/// point at which it crosses the normal through there.
std::vector<Cut> single_planes(const Cut& cut);

/// Whether chance has a part in it.
bool is_drawn(const Cut& cut);

class RandomNumbers;

/// The attitude of the next plane: the cut's own, or one drawn about it where it scatters.
PlaneAttitude drawn_attitude(const Cut& cut, RandomNumbers& random);

/// Rounded, so that the last bits of a library decide nothing.
double to_millionths(double value);

}  // namespace talus
