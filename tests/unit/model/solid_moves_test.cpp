#include "model/solid_moves.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <numbers>

#include "base/error.hpp"
#include "model/rules/solid_rules.hpp"
#include "model/solid_shape.hpp"

namespace talus {
namespace {

using testing::ElementsAre;

const Vec3 somewhere(3, -2, 5);

/// A box that lies askew already.
Solid askew() {
  Solid solid;
  solid.name = "box";
  solid.shape = BoxShape{{0, 0, 0}, {2, 3, 4}};
  solid.turn = Turn{{1, 2, 3}, 40, {5, 1, 0}};
  solid.move = {7, 0, -1};
  return solid;
}

Vec3 rotated(const Turn& turn, const Vec3& point) {
  return turn.about +
         Eigen::AngleAxisd(turn.angle * std::numbers::pi / 180, turn.axis.normalized()) * (point - turn.about);
}

TEST(SolidMovesTest, MovesWhatLiesAskew) {
  const Solid solid = moved(askew(), {1, 2, 3});
  EXPECT_TRUE(placed(solid, somewhere).isApprox(placed(askew(), somewhere) + Vec3(1, 2, 3), 1e-12));
}

TEST(SolidMovesTest, TurnsWhatLiesAskewAboutAnotherAxis) {
  const Turn by{{0, 1, 1}, 75, {-4, 2, 9}};
  const Solid solid = turned(askew(), by);
  EXPECT_TRUE(placed(solid, somewhere).isApprox(rotated(by, placed(askew(), somewhere)), 1e-12));
  EXPECT_TRUE(placed(solid, {-6, 1, 8}).isApprox(rotated(by, placed(askew(), {-6, 1, 8})), 1e-12));
}

TEST(SolidMovesTest, TurnsAboutOneAxisAddUpToTheDigit) {
  Solid solid;
  solid.shape = BoxShape{{0, 0, 0}, {1, 1, 1}};
  for (int i = 0; i < 3; ++i) solid = turned(solid, {{0, 0, 1}, 10.1, {1, 1, 0}});
  EXPECT_EQ(solid.turn->angle, 30.3);
  EXPECT_EQ(solid.turn->about, Vec3(1, 1, 0));
  EXPECT_TRUE(solid.move.isZero(1e-15));
  EXPECT_EQ(turned(solid, {{0, 0, -2}, 30.3, {1, 1, 0}}).turn->angle, 0);
}

TEST(SolidMovesTest, ScalesEveryShapeThatHasCoordinatesAboutAPoint) {
  const Vec3 about(1, 1, -2);
  for (const SolidShape& shape :
       {SolidShape(BoxShape{{0, 0, 0}, {2, 3, 4}}), SolidShape(CylinderShape{{0, 0, 0}, {0, 5, 1}, 2, 12}),
        SolidShape(SectionShape{{{0, 0}, {9, 0}, {9, 4}}, {1, 2, 3}, 30, 5}),
        SolidShape(PolyhedronShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{2, 1, 0}, {1, 3, 0}, {2, 3, 1}, {3, 2, 0}}})}) {
    Solid solid = askew();
    solid.shape = shape;
    const auto before = polyhedron_of(solid).value().vertices;
    const auto after = polyhedron_of(scaled(solid, 3, about, Vec3::Zero())).value().vertices;
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_TRUE(after[i].isApprox(about + 3 * (before[i] - about), 1e-12)) << shape.index();
  }
}

TEST(SolidMovesTest, ScalesAFileByItsUnitAboutAPointOfTheProject) {
  const Vec3 origin(2.6e6, 1.2e6, 400), about(10, 20, 30), in_file(2600010e3, 1200020e3, 420e3);
  Solid solid = askew();
  solid.shape = FileShape{"hill.stl", 1e-3};
  const Solid larger = scaled(solid, 2, about, origin);
  const auto seen = [&](const Solid& one) {
    return placed(one, std::get<FileShape>(one.shape).scale * in_file - origin);
  };
  EXPECT_DOUBLE_EQ(std::get<FileShape>(larger.shape).scale, 2e-3);
  EXPECT_LT((seen(larger) - (about + 2 * (seen(solid) - about))).norm(), 1e-6);
}

TEST(SolidMovesTest, WhatHasTheSizeOfSomethingElseIsNotScaled) {
  Solid solid = askew();
  solid.shape = TerrainShape{"ground.asc", 0, 0};
  EXPECT_THROW(scaled(solid, 2, Vec3::Zero(), Vec3::Zero()), InputError);
  solid.shape = CombinedShape{CombineOperation::unite, {"a", "b"}};
  EXPECT_THROW(scaled(solid, 2, Vec3::Zero(), Vec3::Zero()), InputError);
}

std::vector<std::string> names(const Project& project) {
  std::vector<std::string> all;
  for (const Solid& solid : project.solids) all.push_back(solid.name);
  return all;
}

Project rock_and_tunnel() {
  Project project;
  project.solids = {
      {.name = "rock", .shape = BoxShape{{0, 0, 0}, {10, 10, 10}}, .material = "granite", .mesh_size = 2},
      {.name = "tunnel", .shape = CylinderShape{{5, 0, 5}, {5, 10, 5}, 2}, .material = "air", .mesh_size = {}}};
  return project;
}

TEST(SolidMovesTest, CopiesStandBehindTheirSolidEachAStepFurther) {
  const Project project = with_copies(rock_and_tunnel(), 0, 2, {20, 0, 0});
  EXPECT_THAT(names(project), ElementsAre("rock", "rock 2", "rock 3", "tunnel"));
  EXPECT_EQ(project.solids[2].move, Vec3(40, 0, 0));
}

TEST(SolidMovesTest, ACombinedSolidIsMadeOfTheFirstAndItsParts) {
  const Project project = with_combined(rock_and_tunnel(), CombineOperation::subtract, {0, 1});
  ASSERT_THAT(names(project), ElementsAre("rock", "tunnel", "rock less tunnel"));
  const Solid& made = project.solids.back();
  EXPECT_THAT(std::get<CombinedShape>(made.shape).solids, ElementsAre("rock", "tunnel"));
  EXPECT_EQ(made.material, "granite");
  EXPECT_EQ(made.mesh_size, 2);
  EXPECT_NO_THROW(check_combined_solids(project));
}

TEST(SolidMovesTest, WhatIsAPartAlreadyIsNotCombinedAgain) {
  Project project = with_combined(rock_and_tunnel(), CombineOperation::subtract, {0, 1});
  EXPECT_THROW(with_combined(project, CombineOperation::unite, {1, 2}), InputError);
  EXPECT_THROW(with_combined(project, CombineOperation::unite, {2}), InputError);
}

}  // namespace
}  // namespace talus
