#pragma once

#include <algorithm>
#include <cmath>

namespace talus {

/// How far past the line of a valley [m] what is behind one of its two sides by `depth` [m] is on that side all the
/// same. `cosine`: of the angle between the sides, on the free side. Between the planes square to both sides there it
/// is on neither: in a valley of 90° as far as it is deep, farther the narrower the valley is. Twice as far both hold
/// what runs along the valley.
inline double reach_past_valley(double cosine, double depth) {
  return 2 * depth * std::sqrt(std::max(1.0, (1 + cosine) / (1 - cosine)));
}

}  // namespace talus
