#include "orientation/critical_zone.hpp"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

/// Positive within `limit` degrees of an azimuth.
double within_limit(double azimuth, double middle, double limit) {
  return std::cos(radians(azimuth_difference(azimuth, middle))) - std::cos(radians(limit));
}

/// Positive where the angle is above the other one.
double above(double angle, double other) { return std::sin(radians(angle - other)); }

}  // namespace

double critical_margin(const Vec3& line, FailureMode mode, const KinematicSetting& setting) {
  const LineAttitude at = attitude_of(line);
  const PlaneAttitude& face = setting.face;
  const Vec3 outward = -pole_of(face);
  switch (mode) {
    case FailureMode::planar: {
      const PlaneAttitude plane{90 - at.plunge, at.trend + 180};
      return std::min({dip_vector_of(plane).dot(outward), above(plane.dip, setting.friction_angle),
                       within_limit(plane.dip_direction, face.dip_direction, setting.lateral_limit)});
    }
    case FailureMode::wedge:
      return std::min(line.dot(outward), above(at.plunge, setting.friction_angle));
    case FailureMode::flexural: {
      const Vec3 slip_limit = -pole_of({face.dip - setting.friction_angle, face.dip_direction});
      return std::min({line.dot(slip_limit), within_limit(at.trend, face.dip_direction, setting.lateral_limit),
                       above(face.dip, setting.friction_angle)});
    }
    case FailureMode::direct:
      break;
  }
  return std::min(within_limit(at.trend, face.dip_direction + 180, setting.lateral_limit),
                  above(at.plunge, 90 - face.dip));
}

}  // namespace talus
