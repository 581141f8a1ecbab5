#include "model/body_choice.hpp"

#include "unit/model/slope_project.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

/// Two blocks of rock of 2600 kg/m³ and 25 GPa, of which nothing is asked.
Project quiet_project() {
  Project project = test::slope();
  project.constraints.clear();
  project.loads.clear();
  project.velocities.clear();
  project.stages.push_back(project.stages[0]);
  project.stages[1].name = "then";
  return project;
}

const Vec3 ten_metres(30, 20, 10);

BodyChoice choice(const Project& project, const Vec3& extent = ten_metres) {
  return BodyChooser(project, extent).choose("top", project.materials[0]);
}

void expect_choice(const BodyChoice& choice, BodyKind body, const std::string& words) {
  EXPECT_EQ(to_string(choice.body), to_string(body)) << choice.reason;
  EXPECT_THAT(choice.reason, HasSubstr(words));
}

TEST(BodyChoice, HardRockOfWhichNothingIsAskedIsRigid) {
  // 2600 · 9.81 · 10 / 25e9 = 1.02e-5 would be felt: 8 m are not.
  expect_choice(choice(quiet_project(), {30, 20, 8}), BodyKind::rigid,
                "hard rock: the model's weight strains it by 8.2e-6; nobody asks for its stress");
}

TEST(BodyChoice, StrainThatNeighboursFeelMakesItAffine) {
  expect_choice(choice(quiet_project()), BodyKind::affine, "the model's weight strains it by 1e-5");
  expect_choice(choice(quiet_project(), {30, 20, 900}), BodyKind::affine, "by 0.00092, which its neighbours feel");
}

TEST(BodyChoice, SoftRockIsMeshed) {
  Project project = quiet_project();
  project.materials[0].young = 1e8;  // 2600 · 9.81 · 10 / 1e8
  expect_choice(choice(project), BodyKind::tetrahedra, "soft for its load: the model's weight strains it by 0.0026");
}

TEST(BodyChoice, TheHeightIsThatAlongGravity) {
  Project project = quiet_project();
  project.gravity = {9.81, 0, 0};
  expect_choice(choice(project, {1, 1e4, 1e4}), BodyKind::rigid, "by 1e-6;");
  project.gravity = {0, 0, 0};
  expect_choice(choice(project, {1e4, 1e4, 1e4}), BodyKind::rigid, "by 0;");
}

TEST(BodyChoice, AnImpactCountsByTheLargestSpeedGiven) {
  Project project = quiet_project();
  project.gravity = {0, 0, 0};
  // Also for the block that is run into: v √(ρ/E) = v / 3100.9 m/s.
  project.velocities = {{"slope.1", {0, 3, 4}, {0, 0, 0}}, {"slope.1", {0.1, 0, 0}, {0, 0, 0}}};
  expect_choice(choice(project), BodyKind::tetrahedra, "weight and 5 m/s strain it by 0.0016");
  project.velocities[0].linear = {0, 0.3, 0.4};
  expect_choice(choice(project), BodyKind::affine, "weight and 0.5 m/s strain it by 0.00016");
}

TEST(BodyChoice, WhatAConstraintMovesAsAWholeIsFixed) {
  Project project = quiet_project();
  project.stages[1].constraints = {{Constraint{"top", {}}}};
  expect_choice(choice(project), BodyKind::fixed, "a constraint moves it as a whole");
}

TEST(BodyChoice, WhatEveryStageHoldsIsFixed) {
  Project project = quiet_project();
  project.stages[0].blocks = {{"top", BodyKind::fixed}};
  expect_choice(choice(project), BodyKind::fixed, "every stage holds it");
  project.stages[1].blocks = {{"top", BodyKind::automatic}};
  expect_choice(choice(project), BodyKind::affine, "nobody asks");
  project.stages[0].blocks.clear();
  project.stages[1].blocks = {{"top", BodyKind::fixed}};
  expect_choice(choice(project), BodyKind::affine, "nobody asks");
}

TEST(BodyChoice, WhoseStressIsMonitoredIsMeshed) {
  Project project = quiet_project();
  ASSERT_EQ(project.monitors[0].block, "top");
  EXPECT_EQ(choice(project).body, BodyKind::affine);
  project.monitors.push_back({"P2", "top", {5, 5, 9}, true});
  project.monitors.push_back({"P3", "top", {5, 5, 9}, true});
  expect_choice(choice(project), BodyKind::tetrahedra, "monitor P2 asks for its stress");
}

TEST(BodyChoice, StressInSituMeshesWhomItNames) {
  Project project = quiet_project();
  ASSERT_TRUE(project.in_situ[0].blocks.empty());
  EXPECT_EQ(choice(project).body, BodyKind::affine);
  project.in_situ[0].blocks = {"top"};
  expect_choice(choice(project), BodyKind::tetrahedra, "stress in situ is given for it by name");
}

TEST(BodyChoice, WhatIsHeldOrLoadedAtTwoPointsIsMeshed) {
  Project project = quiet_project();
  const Vec3 here(5, 5, 9), there(6, 5, 9);
  project.constraints = {{"top", here, {0, 0, 0}, {}}};
  EXPECT_EQ(choice(project).body, BodyKind::affine);
  project.loads = {{"top", here, {0, 0, -1e6}, {}}, {"slope.1", there, {0, 0, -1e6}, {}}};
  EXPECT_EQ(choice(project).body, BodyKind::affine) << "one point, and another block's";
  project.stages[1].loads = {{{"top", there, {0, 0, -1e6}, {}}}};
  expect_choice(choice(project), BodyKind::tetrahedra, "held or loaded at 2 points");
  project.stages[1].constraints.emplace();
  EXPECT_EQ(choice(project).body, BodyKind::affine) << "never at both at once";
}

}  // namespace
}  // namespace talus
