#pragma once

#include <vector>

#include "orientation/set_window.hpp"

/// Lines of the net as unit vectors in order, ready for `projected`.
namespace talus {

using NetCurve = std::vector<Vec3>;

/// The plane through the centre of the sphere, from one end of its strike to the other. One more point than `pieces`.
NetCurve great_circle(const PlaneAttitude& plane, int pieces = 90);

/// All lines at `angle` degrees from `axis`: a closed circle on the sphere, cut where it leaves the lower hemisphere.
/// What lies above comes back on the opposite side, since a line has no sense.
std::vector<NetCurve> small_circle(const Vec3& axis, double angle, int pieces = 180);

/// The border of a window as poles, cut where it leaves the lower hemisphere as a small circle is.
std::vector<NetCurve> window_outline(const SetWindow& window);

/// Poles of the planes whose steepest descent lies in the face: inside are the planes that daylight in it, the rim of
/// the daylight envelope of Goodman and of Hoek & Bray. tan(dip) = tan(face dip) · cos(difference of directions).
NetCurve daylight_envelope(const PlaneAttitude& face, int pieces = 90);

}  // namespace talus
