#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/scenes/crowd_parts.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/hard_cases/voronoi.hpp"

namespace talus {

namespace {

constexpr double depth = 3;  // m, of pits, whose rim is at z = 0

/// A square pit in a fixed block.
CaseScene pit_scene(double width, double friction_angle) {
  CaseScene scene = rock_scene(friction_angle);
  scene.add_block("pit", holed_box(width, depth, width / 2 + 1, 1), BodyKind::fixed);
  return scene;
}

/// Numbers in 0 … 1, the same on every machine: those of the standard's engine, not of its distributions.
class Shares {
 public:
  double operator()() { return static_cast<double>(random_()) / 4294967296.0; }
  Vec3 direction() {
    Vec3 direction;
    do direction = 2 * Vec3((*this)(), (*this)(), (*this)()) - Vec3::Ones();
    while (direction.norm() > 1 || direction.norm() < 0.1);
    return direction.normalized();
  }

 private:
  std::mt19937 random_{7};
};

/// The hull of twelve points on an ellipsoid of half axes 0.15 to 0.25 m, turned anyhow.
TetMesh pebble(Shares& share) {
  const Vec3 axes(0.15 + 0.1 * share(), 0.15 + 0.1 * share(), 0.15 + 0.1 * share());
  std::vector<Vec3> corners;
  while (corners.size() < 12) {
    const Vec3 direction = share.direction();
    const bool is_apart = std::all_of(corners.begin(), corners.end(),
                                      [&](const Vec3& other) { return (direction - other).norm() > 0.3; });
    if (is_apart) corners.push_back(direction);
  }
  for (Vec3& corner : corners) corner = corner.cwiseProduct(axes);
  const Mat3 pose = turn_about(share.direction(), 360 * share());
  return placed(hull_mesh(corners), pose, Vec3::Zero());
}

HardCaseExpectation slow_at_end(double speed) {
  return {"all blocks end slower than " + significant(speed) + " m/s", [=](const Trajectory& trajectory) {
            double fastest = 0;
            for (const BlockMotion& block : trajectory.last().blocks)
              fastest = std::max(fastest, block.velocity.norm());
            return fastest < speed ? std::string() : "the fastest ends with " + significant(fastest) + " m/s";
          }};
}

/// Blows give nothing back: a second after the last has come down all lie, though one may still roll.
HardCase poured(int count, double width, double duration) {
  return {.name = "poured_" + std::to_string(count),
          .group = crowd_group,
          .title = std::to_string(count) + " polyhedra poured into a pit",
          .takes_long = count > 20,
          .expected = {stays_before({0, 0, -depth}, Vec3::UnitZ()), slow_at_end(0.5)},
          .build = [=] {
            CaseScene scene = pit_scene(width, 35);
            Shares share;
            constexpr double pitch = 0.52;  // m: none touches another at the start
            const int side = static_cast<int>((width - 0.1) / pitch);
            for (int i = 0; i < count; ++i) {
              const int layer = i / (side * side), place = i % (side * side);
              const Vec3 at(place % side - 0.5 * (side - 1), place / side - 0.5 * (side - 1), layer);
              scene.add_block("pebble " + std::to_string(i + 1),
                              placed(pebble(share), Vec3(0, 0, 0.3 - depth) + pitch * at), BodyKind::rigid);
            }
            scene.project.stages = {dynamic_stage(1e-3, duration)};
            return scene;
          }};
}

/// Voronoi pieces that fill a pit: they can go nowhere but up, and nothing drives them there. Weight, at once on all,
/// presses them into their contacts by micrometres.
HardCase packed(int count) {
  return {.name = "packed_" + std::to_string(count),
          .group = crowd_group,
          .title = std::to_string(count) + " Voronoi pieces packed in a pit",
          .expected = {all_rest(-1, 1e-5)},
          .build = [=] {
            CaseScene scene = pit_scene(2, 30);
            int number = 0;
            for (TetMesh& piece : voronoi_pieces({-1, -1, -depth}, {1, 1, 1 - depth}, count, 3))
              scene.add_block("piece " + std::to_string(++number), std::move(piece), BodyKind::rigid);
            scene.project.stages = {dynamic_stage(1e-3, 1)};
            return scene;
          }};
}

/// A cube with an arm on each face.
TetMesh jack(double bar) {
  const std::vector<double> lines{-1.5 * bar, -0.5 * bar, 0.5 * bar, 1.5 * bar};
  return grid_mesh(lines, lines, lines, [](int i, int j, int k) { return (i == 1) + (j == 1) + (k == 1) >= 2; });
}

/// Jacks fall into each other's arms; what interlocks must not throw anything out of the pit.
HardCase interlocked(int count) {
  constexpr double bar = 0.2, width = 1.6;  // m
  return {.name = "interlocked_" + std::to_string(count),
          .group = crowd_group,
          .title = std::to_string(count) + " jacks fall into each other in a pit",
          .takes_long = count > 8,
          .expected = {stays_before({0, 0, -depth}, Vec3::UnitZ()), stays_before(Vec3::Zero(), -Vec3::UnitZ()),
                       slow_at_end(0.5)},
          .build = [=] {
            CaseScene scene = pit_scene(width, 30);
            Shares share;
            for (int i = 0; i < count; ++i) {
              const Mat3 pose = turn_about(share.direction(), 360 * share());
              const Vec3 at(i & 1 ? 0.38 : -0.38, i & 2 ? 0.38 : -0.38, 0.4 - depth + 0.7 * (i / 4));
              scene.add_block("jack " + std::to_string(i + 1), placed(jack(bar), pose, at), BodyKind::rigid);
            }
            scene.project.stages = {dynamic_stage(1e-3, 1.5)};
            return scene;
          }};
}

}  // namespace

std::vector<HardCase> crowds_in_pits() {
  return {poured(8, 1.6, 2), poured(500, 3.7, 3), packed(12), packed(100), interlocked(4), interlocked(16)};
}

}  // namespace talus
