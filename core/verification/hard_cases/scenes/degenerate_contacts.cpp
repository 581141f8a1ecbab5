#include "verification/hard_cases/scenes/degenerate_contacts.hpp"
#include "base/rotation.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "base/units.hpp"
#include "verification/hard_cases/shapes.hpp"

namespace talus {

namespace {

constexpr double spike_height = 1.5;  // m, of spikes and wedges

void add_floor(CaseScene& scene, double level) { scene.add_fixed_box("floor", {-6, -6, level - 1}, {6, 6, level}); }

/// A fixed body that stands on a floor with its top in the origin, and a block that stands on it.
std::function<void(CaseScene&)> balance(const TetMesh& below, const TetMesh& above, double base) {
  return [=](CaseScene& scene) {
    add_floor(scene, -base);
    scene.add_block("base", below, BodyKind::fixed);
    scene.add_block("block", above, BodyKind::tetrahedra);
  };
}

/// … where both are one mesh, upright below and upside down above, turned against each other about the vertical.
std::function<void(CaseScene&)> balance_of_equals(const TetMesh& upright, double turned) {
  return balance(placed(upright, {0, 0, -spike_height}),
                 placed(upright, turn_about(Vec3::UnitZ(), turned) * upside_down(), {0, 0, spike_height}),
                 spike_height);
}

std::function<void(CaseScene&)> lying(const TetMesh& below, const TetMesh& above) {
  return [=](CaseScene& scene) {
    scene.add_block("base", below, BodyKind::fixed);
    scene.add_block("block", above, BodyKind::tetrahedra);
  };
}

/// A V in the top of a box, along y: 1 m deep and 2 m wide.
TetMesh grooved_box() {
  const auto bar = [](double low_left, double low_right, double high_left, double high_right, double bottom,
                      double top) {
    std::array<Vec3, 8> corners;
    for (int k = 0; k < 8; ++k) {
      const double left = k & 4 ? high_left : low_left, right = k & 4 ? high_right : low_right;
      corners[k] = {k & 1 ? right : left, k & 2 ? 2.0 : -2.0, k & 4 ? top : bottom};
    }
    return hexahedron_mesh(corners, 1, 1, 1);
  };
  return welded(
      {bar(-3, 0, -3, 0, -2, -1), bar(0, 3, 0, 3, -2, -1), bar(-3, 0, -3, -1, -1, 0), bar(0, 3, 1, 3, -1, 0)});
}

TetMesh inner_corner() {
  const std::vector<double> lines{-1, 0, 1};
  return grid_mesh(lines, lines, lines, [](int i, int j, int k) { return i + j + k < 3; });
}

std::vector<DegenerateContact> unstable_contacts() {
  const double diagonal = std::sqrt(3.0);
  const Mat3 on_corner = rotation_onto(Vec3::Ones().normalized(), Vec3::UnitZ());
  const auto on_its_corner = [&](double level) { return placed(cube(1), on_corner, {0, 0, level}); };
  const TetMesh ridge = wedge(1, 1, spike_height);
  return {{"vertex_on_vertex",
           "Cube on its corner on the corner of a cube",
           false,
           balance(on_its_corner(-diagonal / 2), on_its_corner(diagonal / 2), diagonal),
           {0, 0, -diagonal}},
          {"vertex_on_edge",
           "Spike on the ridge of a wedge",
           false,
           balance(placed(ridge, {0, 0, -spike_height}),
                   placed(spike(1, spike_height), upside_down(), {0, 0, spike_height}), spike_height),
           {0, 0, -spike_height}},
          {"edge_along_edge",
           "Wedge on the ridge of a wedge, edge along edge",
           false,
           balance_of_equals(ridge, 0),
           {0, 0, -spike_height}},
          {"edge_across_edge",
           "Wedge on the ridge of a wedge, 1e-9 from parallel",
           false,
           balance_of_equals(ridge, degrees(1e-9)),
           {0, 0, -spike_height}},
          {"spike_on_spike",
           "Slender spike on the tip of a slender spike",
           false,
           balance_of_equals(spike(0.3, spike_height), 0),
           {0, 0, -spike_height}}};
}

std::vector<DegenerateContact> stable_contacts() {
  const TetMesh block = box_mesh({-0.5, -0.5, 0}, {0.5, 0.5, 1}, 2, 2, 2);
  const TetMesh slab = box_mesh({-2, -2, -1}, {2, 2, 0}, 8, 8, 2);
  return {{"faces_coinciding", "Face on face, meshes coinciding", true,
           lying(box_mesh({-0.5, -0.5, -1}, {0.5, 0.5, 0}, 2, 2, 2), block)},
          {"faces_shifted", "Face on face, meshes shifted and mirrored", true,
           lying(box_mesh({-2.13, -2.07, -1}, {1.87, 1.93, 0}, 8, 8, 2, true), block)},
          {"on_inner_edge", "Block whose edges land on inner edges of a mesh", true,
           lying(slab, box_mesh({0, 0, 0}, {0.5, 0.5, 0.5}, 1, 1, 1))},
          {"wedge_in_groove",
           "Wedge in a groove of its shape",
           true,
           lying(grooved_box(), placed(wedge(2, 1, 1), upside_down(), Vec3::Zero())),
           {0, 0, -1},
           Vec3::UnitZ(),
           Vec3::UnitY()},
          {"block_in_hole",
           "Block in a hole of exactly its size",
           true,
           lying(holed_box(1, 1, 1.5, 1), box_mesh({-0.5, -0.5, -1}, {0.5, 0.5, 0}, 1, 1, 1)),
           {0, 0, -1}},
          {"corner_in_corner", "Corner of a cube in a corner of three walls", true,
           lying(inner_corner(), box_mesh({0, 0, 0}, {1, 1, 1}, 1, 1, 1)), Vec3::Zero(), Vec3::Ones().normalized(),
           Vec3(1, -1, 0).normalized()},
          {"thin_crack", "Block across a crack of a thousandth of a millimetre", true,
           lying(slotted_box(1e-6, 0.5, 2, 2, 0.5), block)}};
}

}  // namespace

std::vector<DegenerateContact> degenerate_contacts() {
  std::vector<DegenerateContact> all = unstable_contacts();
  for (DegenerateContact& contact : stable_contacts()) all.push_back(std::move(contact));
  return all;
}

}  // namespace talus
