#pragma once

#include <vector>

#include "model/project.hpp"

/// What the templates are built of.
namespace talus {

/// Where a joint leaves a face, above its toe and of its height: what slides there meets no ground at once.
constexpr double daylight = 0.15;

/// A point of a vertical section: x east, z up [m].
struct SectionPoint {
  double x, z;
};

/// The prism over a profile, counter-clockwise with x to the right and z up, between two northings [m].
PolyhedronShape prism(const std::vector<SectionPoint>& profile, double south, double north);

/// Points along and above a plane that dips to the east, `dip` in degrees, as points of the section: x goes down the
/// dip, z along the plane's upward normal.
std::vector<SectionPoint> on_incline(const std::vector<SectionPoint>& points, double dip);

/// A project of one rock and one joint set "J1", which is that of all contacts; gravity as it is on earth.
Project rock_with_joints(const std::string& name, double friction_angle);

/// A solid of that rock whose blocks may do what they are asked for.
Solid free_rock(const std::string& name, SolidShape shape);

/// One that stays where it is. It is only touched: a coarse mesh of `mesh_size` [m] serves.
Solid fixed_rock(const std::string& name, SolidShape shape, double mesh_size);

/// A plane of that joint set; dip and dip direction in degrees. Limited to `solid` where one is named.
Cut joint_plane(double dip, double dip_direction, const Vec3& through, const std::string& solid = {});

/// Names the block that holds a point, gives it a body, and watches that point.
void add_named_block(Project& project, const std::string& name, const Vec3& at, BodyKind body);

/// Watches a point of a block, as P1, P2 …
void add_monitor(Project& project, const std::string& block, const Vec3& at);

/// A short static stage in which blocks come to bear on each other, and a dynamic one of `duration` s that shows what
/// they do. `size` of the free blocks [m]: steps are a hundredth of the time that a fall by it takes, at most 10 ms.
void add_stages(Project& project, double size, double duration);

}  // namespace talus
