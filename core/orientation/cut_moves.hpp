#pragma once

#include "model/rock/cut.hpp"
#include "orientation/attitude.hpp"

/// A cut in another place: what makes it end (disc, polygon, network) goes with it. Coordinates are rounded to a
/// millimetre.
namespace talus {

/// By so many metres along its upward normal.
Cut moved(Cut cut, double along_normal);

/// Turned about `pivot`, a point of its plane, until it lies as `to` says; it goes through the pivot then, unless a
/// disc, a polygon or a network has its middle elsewhere.
Cut turned(Cut cut, const PlaneAttitude& to, const Vec3& pivot);

/// With the `corner`-th corner of its polygon at the point of its plane nearest to `place`.
Cut with_corner(Cut cut, std::size_t corner, const Vec3& place);

/// Its plane's upward unit normal.
Vec3 normal_of(const Cut& cut);

}  // namespace talus
