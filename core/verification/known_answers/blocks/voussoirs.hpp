#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/vector.hpp"

/// A semicircular arch of equal voussoirs with radial joints, and when it stands by its own weight.
namespace talus {

/// Lengths in units of the mean radius. Voussoirs are plane-sided: their corners lie on the two circles.
struct Arch {
  int voussoirs = 27;
  double thickness = 0.12;
};

/// Corners of voussoir `i` in the plane (x, z), the right springing first: inner and outer of its lower joint, inner
/// and outer of its upper one.
std::array<Eigen::Vector2d, 4> corners(const Arch& arch, int i);

/// The same voussoir of an arch of this mean radius and depth [m], about the plane y = 0: bits of a corner's number are
/// outwards, to the back, on along the arch.
std::array<Vec3, 8> voussoir(const Arch& arch, int i, double radius, double depth);

/// Whether a thrust line fits into the arch that presses on each joint within its friction: the safe theorem of limit
/// analysis, for a friction coefficient, or none for joints that never slip.
bool stands(const Arch& arch, std::optional<double> friction);

/// Least thickness at which it stands, in units of the mean radius; none when it does not at half of it.
/// Milankovitch 1907: 0.1075 for very many voussoirs.
std::optional<double> least_thickness(int voussoirs, std::optional<double> friction);

/// Least friction coefficient at which it stands; none when it does not, however rough its joints are.
std::optional<double> least_friction(const Arch& arch);

}  // namespace talus
