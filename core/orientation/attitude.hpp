#pragma once

#include <string>

#include "base/line_attitude.hpp"
#include "base/vector.hpp"

/// Axes everywhere in this folder: x east, y north, z up. Angles are degrees, azimuths clockwise from north.
namespace talus {

/// The attitude of a plane as geologists write it.
struct PlaneAttitude {
  double dip = 0;            ///< from the horizontal, 0 … 90; what is beyond 90 is overturned, see `upright`
  double dip_direction = 0;  ///< of the steepest descent, 0 … 360
  bool operator==(const PlaneAttitude&) const = default;
};

/// An azimuth between 0 (included) and 360 (excluded).
double azimuth_within_circle(double azimuth);

/// The smaller angle between two azimuths, 0 … 180.
double azimuth_difference(double a, double b);

/// The same plane with a dip of 0 … 90 and a direction of 0 … 360; a dip of 100 towards 30 is one of 80 towards 210.
PlaneAttitude upright(PlaneAttitude plane);

/// Dip direction of a plane whose strike is given by the right-hand rule: it dips to the right of who looks along it.
double dip_direction_of_strike(double strike);

/// Downward unit normal.
Vec3 pole_of(const PlaneAttitude& plane);

/// Unit vector down the plane: its line of steepest descent.
Vec3 dip_vector_of(const PlaneAttitude& plane);

/// Unit vector of a line; downwards where its plunge is positive.
Vec3 direction_of(const LineAttitude& line);

/// The plane that has this normal, of either sense and any length but zero.
PlaneAttitude attitude_of_normal(const Vec3& normal);

/// The line itself or its opposite, whichever does not point upwards.
Vec3 downward(const Vec3& line);

/// "45/120", dip and dip direction, as `plane_from_text` reads it; two digits of a fraction at most.
std::string plane_text(const PlaneAttitude& plane);

/// Reads "45/120": dip 0 … 90, dip direction 0 … 360. Throws InputError, which names `place`.
PlaneAttitude plane_from_text(const std::string& text, const std::string& place);

}  // namespace talus
