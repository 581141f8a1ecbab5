#include "templates/shapes.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"

namespace talus {

namespace {

constexpr double gravity = 9.81;        // m/s²
constexpr double settling_step = 1e-3;  // s
constexpr int settling_steps = 20;      // enough for stiff rock to bear its weight
constexpr double longest_step = 1e-2;   // s
constexpr double frames = 100;          // of the dynamic stage

/// To two digits, so that the project file reads well.
double rounded(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return unit < 1 ? std::round(value / unit) / std::round(1 / unit) : std::round(value / unit) * unit;
}

}  // namespace

PolyhedronShape prism(const std::vector<SectionPoint>& profile, double south, double north) {
  const int n = static_cast<int>(profile.size());
  PolyhedronShape shape;
  for (const double y : {south, north})
    for (const SectionPoint& point : profile) shape.vertices.emplace_back(point.x, y, point.z);
  std::vector<int> near, far;
  for (int i = 0; i < n; ++i) {
    near.push_back(i);
    far.push_back(2 * n - 1 - i);
  }
  shape.faces = {near, far};
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    shape.faces.push_back({next, i, n + i, n + next});
  }
  return shape;
}

std::vector<SectionPoint> on_incline(const std::vector<SectionPoint>& points, double dip) {
  const double c = std::cos(radians(dip)), s = std::sin(radians(dip));
  std::vector<SectionPoint> turned;
  for (const auto& [along, above] : points) turned.push_back({along * c + above * s, -along * s + above * c});
  return turned;
}

Project rock_with_joints(const std::string& name, double friction_angle) {
  Project project;
  project.name = name;
  project.materials = {{.name = "rock", .density = 2600, .young = 25e9, .poisson = 0.24}};
  Joint joint;
  joint.name = "J1";
  joint.friction_angle = friction_angle;
  project.joints = {joint};
  project.default_joint = "J1";
  return project;
}

Solid free_rock(const std::string& name, SolidShape shape) {
  Solid solid;
  solid.name = name;
  solid.shape = std::move(shape);
  solid.material = "rock";
  solid.body = BodyKind::automatic;
  return solid;
}

Solid fixed_rock(const std::string& name, SolidShape shape, double mesh_size) {
  Solid solid = free_rock(name, std::move(shape));
  solid.body = BodyKind::fixed;
  solid.mesh_size = mesh_size;
  return solid;
}

Cut joint_plane(double dip, double dip_direction, const Vec3& through, const std::string& solid) {
  Cut cut;
  cut.joint = "J1";
  cut.dip = dip;
  cut.dip_direction = dip_direction;
  cut.through = through;
  if (!solid.empty()) cut.solids = {solid};
  return cut;
}

void add_named_block(Project& project, const std::string& name, const Vec3& at, BodyKind body) {
  BlockOverride block;
  block.name = name;
  block.at = at;
  block.body = body;
  project.blocks.push_back(block);
  add_monitor(project, name, at);
}

void add_monitor(Project& project, const std::string& block, const Vec3& at) {
  project.monitors.push_back({"P" + std::to_string(project.monitors.size() + 1), block, at});
}

void add_stages(Project& project, double size, double duration) {
  Stage settle, move;
  settle.name = "settle";
  settle.kind = StageKind::static_;
  settle.time_step = settling_step;
  settle.steps = settling_steps;
  move.name = "move";
  move.time_step = std::min(longest_step, rounded(std::sqrt(2 * size / gravity) / 100));
  move.duration = rounded(duration);
  project.stages = {settle, move};
  project.output.every = rounded(duration / frames);
}

}  // namespace talus
