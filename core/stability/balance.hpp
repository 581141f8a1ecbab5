#pragma once

#include "stability/expectations.hpp"

namespace talus {

/// A block that balances on a point or an edge comes down only by going aside or turning over, not through what bears
/// it: wherever its centroid is lower than `allowance` [m] against `up`, it has gone aside by a twentieth of the rest
/// (flanks of our spikes and wedges are no steeper than 10 to 1) or turned by 5°.
Demand comes_down_aside(const std::string& block, const Vec3& up, double allowance);

}  // namespace talus
