#pragma once

#include <span>
#include <vector>

namespace talus {

/// Which frame each picture of a film shows: the one nearest to its moment. `times` [s] ascend; `speed`: seconds of the
/// model in a second of film; `rate`: pictures a second. The first picture shows the first frame, the last one the
/// last. Throws InputError for a speed that is none, or that would make more than a million pictures.
std::vector<int> frames_of_pictures(std::span<const double> times, double speed, int rate);

}  // namespace talus
