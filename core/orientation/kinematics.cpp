#include "orientation/kinematics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

namespace talus {
namespace {

/// The face as the checks below need it.
struct Slope {
  KinematicSetting setting;
  Vec3 outward;      ///< upward unit normal of the face
  Vec3 slip_limit;   ///< upward unit normal of the plane above which the normals of slipping layers lie
  bool layers_slip;  ///< a face flatter than φ lets no layers slip
  double into;       ///< the direction into the slope

  explicit Slope(const KinematicSetting& given)
      : setting(given),
        outward(-pole_of(given.face)),
        slip_limit(-pole_of({std::max(0.0, given.face.dip - given.friction_angle), given.face.dip_direction})),
        layers_slip(given.face.dip > given.friction_angle),
        into(given.face.dip_direction + 180) {
    const auto outside = [](double angle) { return !(angle >= 0 && angle <= 90); };
    if (outside(given.face.dip) || outside(given.friction_angle) || outside(given.lateral_limit))
      throw std::invalid_argument("face dip, friction angle and lateral limit are 0 to 90 degrees");
  }

  bool out_within_limits(double azimuth) const {
    return azimuth_difference(azimuth, setting.face.dip_direction) <= setting.lateral_limit;
  }
  bool in_within_limits(double azimuth) const { return azimuth_difference(azimuth, into) <= setting.lateral_limit; }
};

PlaneFindings findings_of(const PlaneAttitude& plane, const Slope& slope) {
  const double friction = slope.setting.friction_angle;
  const Vec3 pole = pole_of(plane);
  PlaneFindings found;
  found.planar_unlimited = dip_vector_of(plane).dot(slope.outward) > 0 && plane.dip > friction;
  found.planar = found.planar_unlimited && slope.out_within_limits(plane.dip_direction);
  // The pole of a layer that dips into the slope points out of it.
  found.flexural =
      slope.layers_slip && pole.dot(slope.slip_limit) > 0 && slope.out_within_limits(plane.dip_direction + 180);
  found.base = plane.dip <= slope.setting.face.dip && slope.out_within_limits(plane.dip_direction);
  found.base_oblique = !found.base && plane.dip <= friction &&
                       azimuth_difference(plane.dip_direction, slope.setting.face.dip_direction) <= 90;
  return found;
}

/// A plane with what every pair asks of it.
struct Leaf {
  PlaneAttitude plane;
  Vec3 up, descent;  ///< unit vectors: its normal and its steepest descent
};

std::vector<Leaf> leaves_of(std::span<const PlaneAttitude> planes) {
  std::vector<Leaf> leaves;
  for (const PlaneAttitude& plane : planes) leaves.push_back({plane, -pole_of(plane), dip_vector_of(plane)});
  return leaves;
}

/// The two joints of a wedge, which rests upon them.
IntersectionFindings findings_of(const Leaf& first, const Leaf& second, const Vec3& line, const Slope& slope) {
  const double friction = slope.setting.friction_angle;
  IntersectionFindings found;
  found.line = attitude_of(line);
  const bool daylights = line.dot(slope.outward) > 0;
  const bool leaves_second = first.descent.dot(second.up) > 0, leaves_first = second.descent.dot(first.up) > 0;
  const bool slides_on_first = leaves_second && first.plane.dip > friction && first.descent.dot(slope.outward) > 0;
  const bool slides_on_second = leaves_first && second.plane.dip > friction && second.descent.dot(slope.outward) > 0;
  found.wedge = daylights && found.line.plunge > friction;
  found.on_one_plane = found.wedge && (leaves_first || leaves_second);
  found.wedge_flat = daylights && !found.wedge && (slides_on_first || slides_on_second);

  const double off = azimuth_difference(found.line.trend, slope.into);
  found.direct = off <= slope.setting.lateral_limit && found.line.plunge >= 90 - slope.setting.face.dip;
  found.direct_oblique =
      !found.direct && off <= 90 && off > slope.setting.lateral_limit && found.line.plunge >= 90 - friction;
  return found;
}

/// Calls `take` with the findings of all pairs of planes that are not parallel.
template <typename Take>
void for_each_intersection(const std::vector<Leaf>& leaves, const Slope& slope, Take take) {
  constexpr double parallel = 1e-6;  // sine of the angle below which two planes have no line in common
  for (std::size_t i = 0; i < leaves.size(); ++i)
    for (std::size_t j = i + 1; j < leaves.size(); ++j) {
      const Vec3 line = leaves[i].up.cross(leaves[j].up);
      const double sine = line.norm();
      if (sine < parallel) continue;
      IntersectionFindings found = findings_of(leaves[i], leaves[j], downward(line / sine), slope);
      found.first = i;
      found.second = j;
      take(found);
    }
}

void add(KinematicCount& count, bool critical) {
  ++count.total;
  if (critical) ++count.count;
}

void add(KinematicCounts& counts, const PlaneFindings& found) {
  add(counts.planar, found.planar);
  add(counts.planar_unlimited, found.planar_unlimited);
  add(counts.flexural, found.flexural);
  add(counts.base, found.base);
  add(counts.base_oblique, found.base_oblique);
}

void add(KinematicCounts& counts, const IntersectionFindings& found) {
  add(counts.wedge, found.wedge);
  add(counts.on_one_plane, found.on_one_plane);
  add(counts.wedge_flat, found.wedge_flat);
  add(counts.direct, found.direct);
  add(counts.direct_oblique, found.direct_oblique);
}

}  // namespace

KinematicResult kinematic_check(std::span<const PlaneAttitude> planes, const KinematicSetting& setting) {
  const Slope slope(setting);
  KinematicResult result;
  for (const PlaneAttitude& plane : planes) {
    result.planes.push_back(findings_of(plane, slope));
    add(result.counts, result.planes.back());
  }
  for_each_intersection(leaves_of(planes), slope, [&](const IntersectionFindings& found) {
    result.intersections.push_back(found);
    add(result.counts, found);
  });
  return result;
}

KinematicCounts kinematic_counts(std::span<const PlaneAttitude> planes, const KinematicSetting& setting, bool pairs) {
  const Slope slope(setting);
  KinematicCounts counts;
  for (const PlaneAttitude& plane : planes) add(counts, findings_of(plane, slope));
  if (pairs)
    for_each_intersection(leaves_of(planes), slope, [&](const IntersectionFindings& found) { add(counts, found); });
  return counts;
}

}  // namespace talus
