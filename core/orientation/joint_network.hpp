#pragma once

#include <vector>

#include "model/project.hpp"

namespace talus {

/// The discs of a discrete fracture network, each a cut of its own: centres evenly by chance in the box, radii by their
/// law, attitudes by Fisher's distribution about dip and dip direction (all parallel without a κ), until the area of
/// whole discs is the density times the volume of the box or just above (P32; Dershowitz & Herda 1992). Drawn with the
/// cut's seed: the same on every machine, since what is drawn is rounded to 1e-6 m and 1e-6 degrees. `cut` has a
/// network.
std::vector<Cut> discs_of_network(const Cut& cut);

}  // namespace talus
