#include "verification/random/random_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/moments.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/shapes.hpp"

namespace talus {

namespace {

constexpr double most_lengths = 10;  // thicknesses

/// A mesh that is stretched such that it is as thick as asked for.
struct Rough {
  std::string word;
  TetMesh mesh;
};

/// Boxes, of edges 1 (the thickness) and more.
Rough random_box(SceneNumbers& numbers) {
  const double a = numbers.logarithmic(1, most_lengths), b = numbers.logarithmic(1, most_lengths);
  const auto box = [](const Vec3& size) { return box_mesh(-size / 2, size / 2, 1, 1, 1); };
  switch (numbers.whole(0, 3)) {
    case 0:
      return {"cube", box({1, 1, 1})};
    case 1:
      return {"plate", box({std::max(2.0, a), std::max(2.0, b), 1})};
    case 2:
      return {"rod", box({std::max(2.0, a), 1, 1})};
    default:
      return {"box", box({a, b, 1})};
  }
}

Rough random_convex(SceneNumbers& numbers) {
  const double a = numbers.logarithmic(1, most_lengths), b = numbers.logarithmic(1, most_lengths);
  switch (numbers.whole(0, 4)) {
    case 0:
      return {"roof", wedge(a, b, 1)};
    case 1:  // its edges are as sharp as 1 to 10
      return {"sliver", hull_mesh({{0, 0, 0}, {most_lengths, 0, 0}, {0, a, 0}, {0, 0, 1}})};
    case 2:
      return {"tetrahedron", hull_mesh({{0.5, 0.5, 0.5}, {0.5, -0.5, -0.5}, {-0.5, 0.5, -0.5}, {-0.5, -0.5, 0.5}})};
    case 3:
      return {"octahedron", hull_mesh({{0.5, 0, 0}, {-0.5, 0, 0}, {0, a, 0}, {0, -a, 0}, {0, 0, 0.5}, {0, 0, -0.5}})};
    default:
      return {"prism", prism(numbers.whole(3, 8), 0.5 * a, b)};
  }
}

/// Bars of one thickness.
Rough random_hollowed(SceneNumbers& numbers) {
  const double arm = numbers.logarithmic(1, most_lengths / 2);
  const std::vector<double> crossed{-arm - 0.5, -0.5, 0.5, arm + 0.5}, flat{0, 1}, ended{0, 1, 1 + arm};
  switch (numbers.whole(0, 4)) {
    case 0:
      return {"cross", grid_mesh(crossed, crossed, flat, [](int i, int j, int) { return i == 1 || j == 1; })};
    case 1:
      return {"L", grid_mesh(ended, ended, flat, [](int i, int j, int) { return i == 0 || j == 0; })};
    case 2:
      return {"T", grid_mesh(crossed, ended, flat, [](int i, int j, int) { return i == 1 || j == 0; })};
    case 3:
      return {"U",
              grid_mesh({0, 1, 1 + arm, 2 + arm}, ended, flat, [](int i, int j, int) { return i != 1 || j == 0; })};
    default:
      return {"jack", grid_mesh(crossed, crossed, crossed,
                                [](int i, int j, int k) { return (i == 1) + (j == 1) + (k == 1) >= 2; })};
  }
}

/// As thick as asked for, about its centroid.
RandomShape shape_of(Rough rough, double thickness) {
  const Vec3 centroid = volume_moments(rough.mesh).centroid;
  RandomShape shape{rough.word, std::move(rough.mesh), thickness, 0};
  for (Vec3& node : shape.mesh.nodes) {
    node = thickness * (node - centroid);
    shape.radius = std::max(shape.radius, node.norm());
  }
  return shape;
}

/// Between its flat sides it is as thick as along its axis, or more.
Rough random_ring(SceneNumbers& numbers) {
  const int sides = 4 * numbers.whole(2, 4);
  return {"ring", ring(numbers.logarithmic(0.7, most_lengths / 2), 1 / std::cos(std::numbers::pi / sides), sides)};
}

Rough random_gripping(SceneNumbers& numbers) {
  const double a = numbers.logarithmic(2, most_lengths), b = numbers.logarithmic(1, most_lengths);
  switch (numbers.whole(0, 4)) {
    case 0:
      return {"hook", hook(numbers.between(0.7, 3), std::max(1.5, b / 2), 0.8)};
    case 1:
      return random_ring(numbers);
    case 2:  // its edge is as sharp as 1 to a
      return {"wedge", hull_mesh({{0, 0, 0}, {a, 0, 0}, {0, 0, 1}, {0, b, 0}, {a, b, 0}, {0, b, 1}})};
    case 3:
      return {"sliver", hull_mesh({{0, 0, 0}, {most_lengths, 0, 0}, {0, a, 0}, {0, 0, 1}})};
    default:
      return {"plate", box_mesh({0, 0, 0}, {a, std::max(2.0, b), 1}, 1, 1, 1)};
  }
}

}  // namespace

RandomShape random_shape(SceneNumbers& numbers, double thickness, bool hollowed) {
  const int kind = numbers.whole(0, hollowed ? 2 : 1);
  return shape_of(kind == 0   ? random_box(numbers)
                  : kind == 1 ? random_convex(numbers)
                              : random_hollowed(numbers),
                  thickness);
}

RandomShape random_gripping_shape(SceneNumbers& numbers) { return shape_of(random_gripping(numbers), 1); }

void add_random_block(CaseScene& scene, const std::string& name, const RandomShape& shape, BodyKind body,
                      const Mat3& turn, const Vec3& centroid, SceneNumbers& numbers, int material) {
  constexpr std::size_t most_coarse = 24;  // tetrahedra: eight times as many are enough
  const bool wished = numbers.chance(0.3);
  const bool finer = wished && body == BodyKind::tetrahedra && shape.mesh.tetrahedra.size() <= most_coarse;
  scene.add_block(name, placed(finer ? refined(shape.mesh) : shape.mesh, turn, centroid), body, material);
}

CaseScene random_rock_scene(SceneNumbers& numbers, double friction_angle) {
  CaseScene scene = rock_scene(friction_angle);
  Material& rock = scene.project.materials[0];
  rock.density = numbers.between(2000, 3000);
  rock.young = numbers.logarithmic(1e9, 1e11);
  rock.poisson = numbers.between(0, 0.35);
  draw_settings(numbers, scene.project.solver);
  return scene;
}

void draw_settings(SceneNumbers& numbers, SolverSettings& settings) {
  const double stiffness = numbers.logarithmic(1.0 / 3, 3);
  if (numbers.chance(0.3)) settings.contact_stiffness *= stiffness;
  if (numbers.chance(0.1)) settings.time_step_control = TimeStepControl::adaptive;
  if (numbers.chance(0.1)) settings.tolerance = reference_tolerance.value;
}

Site::Site(SceneNumbers& numbers) : azimuth(numbers.between(0, 360)) {
  const Vec3 place(numbers.between(-5e6, 5e6), numbers.between(-5e6, 5e6), numbers.between(-1e3, 4e3));
  const int kind = numbers.whole(0, 3);
  if (kind == 1) shift = 1e-3 * place;
  if (kind >= 2) shift = place;
}

Mat3 Site::turn() const { return turn_about(Vec3::UnitZ(), azimuth); }

std::string Site::words() const {
  return "azimuth " + significant(azimuth) + "°, " + significant(shift.norm()) + " m from the origin";
}

Stage settling_stage(double time_step) {
  Stage stage = static_stage(time_step, 200);
  stage.until_equilibrium = true;
  stage.equilibrium_tolerance = 1e-6;  // a tower that bends goes on swinging by a hundred times as much of its bending
  return stage;
}

}  // namespace talus
