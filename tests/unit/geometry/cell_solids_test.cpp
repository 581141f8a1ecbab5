#include <gmock/gmock.h>

#include <cmath>

#include "base/stopwatch.hpp"
#include "solid_files.hpp"

// Solids of many triangles, which are cut as convex cells: the same promises as for all others.
namespace talus {
namespace {

using namespace rock;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class CellSolids : public SolidFiles {
 protected:
  /// n × n points over 100 m × 100 m, as a terrain down to −50 m.
  Project hill(int n) const {
    std::ofstream file(at("hill.xyz"));
    file << std::setprecision(17);
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const double x = 100.0 * i / (n - 1), y = 100.0 * k / (n - 1);
        file << x << " " << y << " " << 40 * (1 - x / 100) + 6 * std::sin(0.11 * x) * std::cos(0.07 * y) << "\n";
      }
    file.close();
    Project p = project_of({solid("hill", TerrainShape{"hill.xyz", -50, 0})});
    p.solids[0].body = BodyKind::rigid;
    return p;
  }

  static Cut set(const std::string& joint, double dip, double dip_direction, double spacing, int count) {
    Cut made = cut(joint, dip, dip_direction, {50.1, 49.7, 5.3});
    const double tilt = dip * std::acos(-1) / 180, azimuth = dip_direction * std::acos(-1) / 180;
    made.through -= spacing * (count / 2) *
                    Vec3(std::sin(tilt) * std::sin(azimuth), std::sin(tilt) * std::cos(azimuth), std::cos(tilt));
    made.spacing = spacing;
    made.count = count;
    return made;
  }
};

/// A ball of 10 m around (100, 0, 0), of 4 n² − 4 n triangles.
PolyhedronShape ball(int n) {
  const double pi = std::acos(-1);
  const int around = 2 * n;
  const Vec3 centre(100, 0, 0);
  const auto at = [&](int row, int column) { return 1 + (row - 1) * around + column % around; };
  PolyhedronShape shape;
  shape.vertices.push_back(centre + 10 * Vec3::UnitZ());
  for (int row = 1; row < n; ++row)
    for (int column = 0; column < around; ++column) {
      const double tilt = pi * row / n, azimuth = 2 * pi * column / around;
      shape.vertices.push_back(
          centre + 10 * Vec3(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)));
    }
  shape.vertices.push_back(centre - 10 * Vec3::UnitZ());
  const int last = static_cast<int>(shape.vertices.size()) - 1;
  for (int column = 0; column < around; ++column) {
    shape.faces.push_back({0, at(1, column), at(1, column + 1)});
    shape.faces.push_back({last, at(n - 1, column + 1), at(n - 1, column)});
    for (int row = 1; row + 1 < n; ++row) {
      shape.faces.push_back({at(row, column), at(row + 1, column), at(row + 1, column + 1)});
      shape.faces.push_back({at(row, column), at(row + 1, column + 1), at(row, column + 1)});
    }
  }
  return shape;
}

TEST_F(CellSolids, ArePolyhedraOfManyFacesThatDeform) {
  Project p = project_of({solid("ball", ball(48), 4)});  // 9 024 faces: OpenCASCADE takes a minute to cut them
  p.cuts = {cut("J1", 35, 90, {100, 0, 0})};
  double seconds = 0;
  BlockSystem system;
  {
    const Stopwatch watch(seconds);
    system = build(p, folder());
  }
  EXPECT_LT(seconds, 25);
  ASSERT_EQ(system.blocks.size(), 2u);
  expect_sound(system, system.solids_volume);
  EXPECT_NEAR(system.solids_volume / (4.0 / 3 * std::acos(-1) * 1000), 1, 0.01);
  EXPECT_EQ(system.blocks[0].body, BodyKind::tetrahedra);
}

TEST_F(CellSolids, OfPolyhedraThatCrossThemselvesAreRefusedWithThePlace) {
  PolyhedronShape torn = ball(20);
  torn.vertices[41] = Vec3(120, 0, 0);  // through the other side
  const std::string error = error_of(project_of({solid("ball", torn, 4)}), folder());
  EXPECT_THAT(error, StartsWith("solid ball: "));
  EXPECT_THAT(error, HasSubstr("cross"));
}

TEST_F(CellSolids, OfATerrainAreCutBySetsOfJoints) {
  Project p = hill(41);
  p.cuts = {set("J1", 60, 90, 30, 3), set("J2", 80, 200, 30, 3), set("J3", 25, 300, 30, 3)};
  const BlockSystem system = build(p, folder());
  EXPECT_GT(system.blocks.size(), 40u);
  expect_sound(system, system.solids_volume);
  for (int joint = 0; joint < 3; ++joint) {
    double one_side = 0, other = 0;
    for (const Block& b : system.blocks)
      for (const SurfaceTriangle& t : b.surface)
        if (t.joint == joint) {
          const auto& n = b.mesh.nodes;
          const Vec3 area = (n[t.nodes[1]] - n[t.nodes[0]]).cross(n[t.nodes[2]] - n[t.nodes[0]]) / 2;
          (area.z() > 0 ? one_side : other) += area.norm();
        }
    EXPECT_GT(one_side, 1000);
    EXPECT_NEAR(one_side, other, 1e-9 * one_side);
  }
}

TEST_F(CellSolids, OfAClosedSurfaceAreCutAsWell) {
  write_stl("ball.stl", sphere(5, 3));
  Project p = project_of({solid("ball", FileShape{"ball.stl"})});
  p.solids[0].body = BodyKind::rigid;
  p.cuts = {cut("J1", 0, 0, {0, 0, 0.3}), cut("J2", 90, 90, {0.2, 0, 0})};
  const BlockSystem system = build(p, folder());
  ASSERT_EQ(system.blocks.size(), 4u);
  expect_sound(system, volume_of(sphere(5, 3)));
}

TEST_F(CellSolids, KeepTheBitsOfTheirVolumeWhereverTheyAreMerged) {
  Project p = hill(31);
  p.cuts = {cut("J1", 90, 90, {40, 0, 0}), cut("J2", 90, 90, {60, 0, 0})};
  const BlockSystem three = build(p, folder());
  ASSERT_EQ(three.blocks.size(), 3u);
  p.merges = {{{50, 50, -20}, {20, 50, -20}}};
  p.blocks = {{"west", {50, 50, -20}, {}, {}, {}}};
  const BlockSystem two = build(p, folder());
  ASSERT_EQ(two.blocks.size(), 2u);
  EXPECT_NEAR(block(two, "west").volume, three.blocks[0].volume + three.blocks[1].volume, 1e-9 * 1e5);
  EXPECT_EQ(joint_areas(block(two, "west")).count(0), 0u);
  expect_sound(two, two.solids_volume);
  p.blocks[0].removed = true;
  EXPECT_NEAR(build(p, folder()).excavated_volume, block(two, "west").volume, 1e-6);
}

TEST_F(CellSolids, AreMeshedAsFinelyAsIsWanted) {
  Project p = hill(21);
  p.solids[0].body = BodyKind::tetrahedra;
  p.solids[0].mesh_size = 12;
  p.cuts = {cut("J1", 35, 120, {50, 50, 0})};
  const BlockSystem system = build(p, folder());
  ASSERT_EQ(system.blocks.size(), 2u);
  expect_sound(system, system.solids_volume);
  p.mesh.refinements = {{Vec3(50, 50, 0), 15, 4}};
  const BlockSystem refined = build(p, folder());
  expect_sound(refined, system.solids_volume);
  EXPECT_GT(refined.blocks[0].mesh.tetrahedra.size(),
            1.5 * static_cast<double>(system.blocks[0].mesh.tetrahedra.size()));
}

TEST_F(CellSolids, AreCutAlongPlanesWithoutEndAlone) {
  Project p = hill(31);
  p.cuts = {cut("J1", 0, 0, {50, 50, -20})};
  p.cuts[0].disc = {{50, 50, -20}, 5};
  EXPECT_THAT(error_of(p, folder()), AllOf(StartsWith("cut 1 (J1): ends, and solid hill is cut along planes"),
                                           HasSubstr("let it go through")));
}

TEST_F(CellSolids, OfTenThousandPointsAndAThousandBlocksTakeSeconds) {
  Project p = hill(100);
  p.cuts = {set("J1", 60, 90, 9, 10), set("J2", 80, 200, 9, 10), set("J3", 25, 300, 9, 10)};
  p.splinters.rule = SplinterRule::merge;
  double seconds = 0;
  BlockSystem system;
  {
    const Stopwatch watch(seconds);
    system = build(p, folder());
  }
  EXPECT_GT(system.blocks.size(), 800u);
  EXPECT_LT(seconds, 30);  // where others compute beside it
  double sum = 0;
  for (const Block& b : system.blocks) sum += b.volume;
  EXPECT_NEAR(sum, system.solids_volume, 1e-9 * sum);
}

}  // namespace
}  // namespace talus
