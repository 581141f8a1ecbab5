#include "orientation/net_curves.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace talus {
namespace {

/// Unit vector at `turn` radians in the plane of the perpendicular unit vectors `from` and `towards`.
Vec3 turned(const Vec3& from, const Vec3& towards, double turn) {
  return std::cos(turn) * from + std::sin(turn) * towards;
}

/// Where the piece from a to b of a curve crosses the horizon.
Vec3 on_horizon(const Vec3& a, const Vec3& b) {
  Vec3 between = a + (b - a) * (a.z() / (a.z() - b.z()));
  between.z() = 0;
  return between.normalized();
}

/// What lies above the horizon, turned to the opposite side; a curve is cut where it crosses.
std::vector<NetCurve> lowered(const NetCurve& curve) {
  std::vector<NetCurve> pieces(1, {downward(curve.front())});
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Vec3 &from = curve[i - 1], &to = curve[i];
    if ((from.z() > 0) != (to.z() > 0)) {
      const Vec3 rim = on_horizon(from, to);
      pieces.back().push_back(from.z() > 0 ? Vec3(-rim) : rim);
      pieces.push_back({to.z() > 0 ? Vec3(-rim) : rim});
    }
    pieces.back().push_back(downward(to));
  }
  return pieces;
}

}  // namespace

NetCurve great_circle(const PlaneAttitude& plane, int pieces) {
  const Vec3 strike = direction_of({plane.dip_direction - 90, 0}), descent = dip_vector_of(plane);
  NetCurve curve;
  for (int i = 0; i <= pieces; ++i) curve.push_back(turned(strike, descent, std::numbers::pi * i / pieces));
  return curve;
}

std::vector<NetCurve> small_circle(const Vec3& axis, double angle, int pieces) {
  const Vec3 centre = axis.normalized(), first = centre.unitOrthogonal(), second = centre.cross(first);
  const double reach = std::sin(radians(angle)), height = std::cos(radians(angle));
  NetCurve circle;
  for (int i = 0; i <= pieces; ++i)
    circle.push_back(height * centre + reach * turned(first, second, 2 * std::numbers::pi * i / pieces));
  return lowered(circle);
}

std::vector<NetCurve> window_outline(const SetWindow& window) {
  if (const auto* cone = std::get_if<ConeWindow>(&window)) return small_circle(pole_of(cone->centre), cone->half_angle);
  const auto& range = std::get<RangeWindow>(window);
  constexpr int pieces = 60;
  const double width = range.direction_to - range.direction_from;
  const double turn = std::abs(width) >= 360 ? 360 : azimuth_within_circle(width);
  const double dips = range.dip_to - range.dip_from;
  NetCurve border;
  const auto add = [&](double dip_share, double direction_share) {
    border.push_back(pole_of({range.dip_from + dip_share * dips, range.direction_from + direction_share * turn}));
  };
  for (int i = 0; i <= pieces; ++i) add(0, static_cast<double>(i) / pieces);
  for (int i = 1; i <= pieces; ++i) add(static_cast<double>(i) / pieces, 1);
  for (int i = 1; i <= pieces; ++i) add(1, 1 - static_cast<double>(i) / pieces);
  for (int i = 1; i <= pieces; ++i) add(1 - static_cast<double>(i) / pieces, 0);
  return lowered(border);
}

NetCurve daylight_envelope(const PlaneAttitude& face, int pieces) {
  NetCurve curve;
  for (const Vec3& line : great_circle(face, pieces)) {
    const LineAttitude descent = attitude_of(line);
    curve.push_back(pole_of({descent.plunge, descent.trend}));
  }
  return curve;
}

}  // namespace talus
