#pragma once

#include "model/rock/cut.hpp"

namespace talus {

/// m, standard deviation of a lognormal radius: half the mean where none is given.
double radius_deviation(const JointNetwork& network);

/// About how many discs a network has: its area over that of a disc by the mean.
double expected_discs(const JointNetwork& network);

}  // namespace talus
