#include "bench/crowd_scenes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "base/units.hpp"
#include "geometry/block_builder.hpp"
#include "mesh/structured_mesh.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/shapes.hpp"

namespace talus {
namespace {

/// Numbers that are the same on every machine: the library's distributions are not.
class Chance {
 public:
  explicit Chance(int seed) : engine_(static_cast<std::uint32_t>(seed)) {}
  double between(double low, double high) { return low + (high - low) * (engine_() + 0.5) / 4294967296.0; }
  int index(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  double gauss() { return std::sqrt(-2 * std::log(between(0, 1))) * std::cos(between(0, 2 * std::numbers::pi)); }
  Mat3 turn() {
    Eigen::Quaterniond turn;
    for (double& part : turn.coeffs()) part = gauss();
    return turn.normalized().toRotationMatrix();
  }

 private:
  std::mt19937 engine_;
};

const PolyhedronShape cube_shape{
    {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}},
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
const PolyhedronShape octahedron_shape{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
const PolyhedronShape prism_shape{
    {{1, 0, -1}, {-0.5, 0.9, -1}, {-0.5, -0.9, -1}, {1, 0, 1}, {-0.5, 0.9, 1}, {-0.5, -0.9, 1}},
    {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
const PolyhedronShape tetrahedron_shape{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                        {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};

Solid solid(const std::string& name, BodyKind body, SolidShape shape) {
  return {.name = name, .shape = std::move(shape), .material = "rock", .body = body, .mesh_size = {}};
}

template <typename Place>
PolyhedronShape shape_at(PolyhedronShape shape, Place place) {
  for (Vec3& vertex : shape.vertices) vertex = place(vertex);
  return shape;
}

std::string cube_name(int i, int j, int k) {
  return "c" + std::to_string(i) + "_" + std::to_string(j) + "_" + std::to_string(k);
}

void add_pile(Project& project, const Crowd& crowd) {
  const int n = crowd.n;
  project.solids.push_back(solid("slab", BodyKind::fixed, BoxShape{Vec3(-5, -5, -1), Vec3(n + 5, n + 5, 0)}));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        project.solids.push_back(
            solid(cube_name(i, j, k), crowd.body, BoxShape{Vec3(i, j, k), Vec3(i + 1, j + 1, k + 1)}));
  project.joints[0].friction_angle = 35;
}

void add_slide(Project& project, const Crowd& crowd) {
  const int n = crowd.n;
  const Mat3 dips = Eigen::AngleAxisd(radians(20), Vec3::UnitY()).toRotationMatrix();
  const auto add = [&](const std::string& name, BodyKind body, const Vec3& low, const Vec3& high) {
    const auto place = [&](const Vec3& corner) -> Vec3 {
      return dips * ((low + high) / 2 + corner.cwiseProduct(high - low) / 2);
    };
    project.solids.push_back(solid(name, body, shape_at(cube_shape, place)));
  };
  add("slab", BodyKind::fixed, Vec3(-5, -5, -1), Vec3(4 * n + 20, n + 5, 0));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) add(cube_name(i, j, k), crowd.body, Vec3(i, j, k), Vec3(i + 1, j + 1, k + 1));
  project.joints[0].friction_angle = 10;
}

void add_pour(Project& project, const Crowd& crowd, Chance& chance) {
  const int n = crowd.n, row = static_cast<int>(std::ceil(std::cbrt(n / 4.0) * 1.2)) + 1;
  const double side = 1.5 * row, top = 1.5 * (n / (row * row) + 2) + 2;
  const auto wall = [&](const char* name, const Vec3& low, const Vec3& high) {
    project.solids.push_back(solid(name, BodyKind::fixed, BoxShape{low, high}));
  };
  wall("floor", Vec3(-1, -1, -1), Vec3(side + 1, side + 1, 0));
  wall("west", Vec3(-1, -1, 0), Vec3(0, side + 1, top));
  wall("east", Vec3(side, -1, 0), Vec3(side + 1, side + 1, top));
  wall("south", Vec3(0, -1, 0), Vec3(side, 0, top));
  wall("north", Vec3(0, side, 0), Vec3(side, side + 1, top));
  const PolyhedronShape* shapes[] = {&cube_shape, &octahedron_shape, &prism_shape, &tetrahedron_shape};
  for (int k = 0; k < n; ++k) {
    const PolyhedronShape& shape = *shapes[chance.index(4)];
    const Mat3 turn = chance.turn();
    Vec3 size;
    for (int axis = 0; axis < 3; ++axis) size[axis] = chance.between(0.2, 0.5);
    const Vec3 centre(1.5 * (k % row + 0.5), 1.5 * (k / row % row + 0.5), 1 + 1.5 * (k / (row * row)));
    const auto place = [&](const Vec3& corner) -> Vec3 { return centre + turn * corner.cwiseProduct(size); };
    project.solids.push_back(solid("p" + std::to_string(k), crowd.body, shape_at(shape, place)));
  }
  project.joints[0].friction_angle = 27;
}

/// A set of planes, `spacing` apart [m], from one end of the rock to the other.
Cut through_all(const std::vector<Vec3>& rock, double dip, double direction, double spacing, double start) {
  const double d = radians(dip), a = radians(direction);
  const Vec3 pole(std::sin(d) * std::sin(a), std::sin(d) * std::cos(a), std::cos(d));
  double low = 1e300, high = -1e300;
  for (const Vec3& corner : rock) {
    low = std::min(low, pole.dot(corner));
    high = std::max(high, pole.dot(corner));
  }
  const double first = low + start * spacing;
  return {.joint = "j",
          .dip = dip,
          .dip_direction = direction,
          .through = first * pole,
          .spacing = spacing,
          .count = std::max(1, static_cast<int>((high - first) / spacing)),
          .solids = {"rock"}};
}

void add_slope(Project& project, const Crowd& crowd, Chance& chance) {
  constexpr double length = 40, thick = 12, depth = 5;  // m
  const double dip = chance.between(25, 45), slope = std::tan(radians(dip));
  std::vector<Vec3> foot, bedding, top;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {length, 0.0}, {length, length}, {0.0, length}}) {
    foot.emplace_back(x, y, -depth);
    bedding.emplace_back(x, y, x * slope);
    top.emplace_back(x, y, x * slope + thick);
  }
  const std::vector<std::vector<int>> faces{{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5},
                                            {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
  const auto between = [](std::vector<Vec3> below, const std::vector<Vec3>& above) {
    below.insert(below.end(), above.begin(), above.end());
    return below;
  };
  const std::vector<Vec3> rock = between(bedding, top);
  project.solids.push_back(solid("bedrock", BodyKind::fixed, PolyhedronShape{between(foot, bedding), faces}));
  project.solids.push_back(solid("rock", crowd.body, PolyhedronShape{rock, faces}));
  const int beds = std::max(1, static_cast<int>(std::lround(crowd.n / 3.0)));
  const double bed = thick / (beds + 1);
  project.cuts.push_back({.joint = "j",
                          .dip = dip,
                          .dip_direction = 270,
                          .through = Vec3(0, 0, bed),
                          .spacing = bed * std::cos(radians(dip)),
                          .count = beds,
                          .solids = {"rock"}});
  const double spacing = length / crowd.n;
  for (const double from : {150.0, 60.0}) {
    const double direction = chance.between(from, from + 60), dip_of_set = chance.between(60, 88);
    const double apart = spacing * chance.between(0.9, 1.2);
    project.cuts.push_back(through_all(rock, dip_of_set, direction, apart, chance.between(0.3, 0.7)));
  }
  const double below_dip = chance.between(5, 15);
  project.joints[0].friction_angle = crowd.kind == CrowdKind::stand ? dip + 10 : dip - below_dip;
}

TetMesh mesh_of(const SolidShape& shape, int cells) {
  const auto* box = std::get_if<BoxShape>(&shape);
  if (box && cells > 0) return box_mesh(box->min, box->max, cells, cells, cells);
  if (box)
    return convex_mesh(shape_at(cube_shape,
                                [&](const Vec3& corner) -> Vec3 {
                                  return (box->min + box->max) / 2 + corner.cwiseProduct(box->max - box->min) / 2;
                                })
                           .vertices,
                       cube_shape.faces);
  const auto& polyhedron = std::get<PolyhedronShape>(shape);
  return convex_mesh(polyhedron.vertices, polyhedron.faces);
}

constexpr const char* word(CrowdKind kind) {
  constexpr const char* words[] = {"pile", "slide", "pour", "slope", "stand"};
  return words[static_cast<int>(kind)];
}

}  // namespace

std::string name_of(const Crowd& crowd) {
  std::string name = word(crowd.kind) + (" " + std::to_string(crowd.n));
  if (crowd.seed != 1) name += ", seed " + std::to_string(crowd.seed);
  if (crowd.cells > 0)
    return name + ", of " + std::to_string(6 * crowd.cells * crowd.cells * crowd.cells) + " tetrahedra";
  return crowd.body == BodyKind::rigid ? name : name + ", " + std::string(to_string(crowd.body));
}

Project project_of(const Crowd& crowd) {
  Project project;
  project.name = name_of(crowd);
  project.materials = {{.name = "rock", .density = 2600, .young = 2e10, .poisson = 0.25}};
  Joint joint;
  joint.name = "j";
  project.joints = {joint};
  project.default_joint = "j";
  project.stages = {dynamic_stage(crowd.time_step, crowd.time_step * crowd.steps)};
  project.solver.sleep_tolerance = crowd.sleeps ? project.solver.sleep_tolerance : 0;
  project.output.every = 1e9;
  project.splinters.rule = SplinterRule::merge;
  Chance chance(crowd.seed);
  switch (crowd.kind) {
    case CrowdKind::pile:
      add_pile(project, crowd);
      break;
    case CrowdKind::slide:
      add_slide(project, crowd);
      break;
    case CrowdKind::pour:
      add_pour(project, crowd, chance);
      break;
    case CrowdKind::slope:
    case CrowdKind::stand:
      add_slope(project, crowd, chance);
  }
  return project;
}

CaseScene scene_of(const Crowd& crowd) {
  CaseScene scene{project_of(crowd), {}};
  if (!scene.project.cuts.empty()) {
    NoProgress silent;
    scene.system = build_blocks(scene.project, ".", silent);
    return scene;
  }
  scene.system.joint_names = {"j"};
  for (const Solid& one : scene.project.solids)
    scene.add_block(one.name, mesh_of(one.shape, one.body == BodyKind::fixed ? 0 : crowd.cells), one.body);
  return scene;
}

}  // namespace talus
