#include "unit/model/slope_project.hpp"

namespace talus {
namespace {

using namespace test;

class BodyRules : public testing::TestWithParam<BadProject> {};

TEST_P(BodyRules, SayPlaceProblemAndRemedy) { expect_refused(GetParam()); }

const std::vector<BadProject> bad_bodies{
    {"whole block that moves",
     [](Project& p) {
       p.constraints = {Constraint{"top", {}}};
     },
     "/constraints/0", "moves block 'top' as a whole, which is not fixed", "add the point 'at'"},
    {"whole block, in a stage",
     [](Project& p) {
       p.stages[0].constraints = {{Constraint{"slope.1", {}}}};
     },
     "/stages/0/constraints/0", "moves block 'slope.1' as a whole", "body 'fixed'"},
    {"whole block, a component free",
     [](Project& p) {
       p.blocks[0].body = BodyKind::fixed;
       p.constraints = {{"top", {}, {0, {}, 0}}};
     },
     "/constraints/0", "leaves a component free", "0 where the block stays"},
    {"built fixed",
     [](Project& p) {
       p.blocks[0].body = BodyKind::fixed;
       p.stages[0].blocks = {{"top", BodyKind::tetrahedra}};
     },
     "/stages/0/blocks/0/name", "'top' is built fixed", "'tetrahedra' say, and hold it"},
    {"another kind",
     [](Project& p) {
       p.stages[0].blocks = {{"top", BodyKind::affine}};
     },
     "/stages/0/blocks/0/body", "built as 'tetrahedra' and cannot become 'affine'", "'fixed' to hold it"},
    {"auto is asked for or not",
     [](Project& p) {
       p.stages[0].blocks = {{"top", BodyKind::automatic}};
     },
     "/stages/0/blocks/0/body", "built as 'tetrahedra' and cannot become 'auto'", "or 'tetrahedra' to let it go"},
    {"stress of a fixed block",
     [](Project& p) {
       p.blocks[0].body = BodyKind::fixed;
       p.monitors[0].stress = true;
     },
     "/monitors/0/stress", "block 'top' is 'fixed' and has no stress", "'affine'"},
    {"stress of a rigid block",
     [](Project& p) {
       p.solids[0].body = BodyKind::rigid;
       p.monitors[0].stress = true;
     },
     "/monitors/0/stress", "block 'top' is 'rigid' and has no stress", "'tetrahedra'"},
    {"stress in situ of a rigid block",
     [](Project& p) {
       p.solids[0].body = BodyKind::rigid;
       p.in_situ = {{.blocks = {"top"}}};
     },
     "/in_situ/0/blocks/0", "block 'top' is 'rigid' and bears no stress", "'tetrahedra'"},
    {"held twice",
     [](Project& p) {
       p.stages[0].blocks = {{"top", BodyKind::fixed}, {"top", BodyKind::tetrahedra}};
     },
     "/stages/0/blocks/1/name", "'top' is changed twice", "keep one"},
};
INSTANTIATE_TEST_SUITE_P(Values, BodyRules, testing::ValuesIn(bad_bodies));

TEST(BodyRulesOfGoodProjects, ABlockIsHeldAndLetGo) {
  Project project = slope();
  project.stages.push_back(project.stages[0]);
  project.stages[1].name = "released";
  project.stages[0].blocks = {{"top", BodyKind::fixed}};
  project.stages[1].blocks = {{"top", BodyKind::tetrahedra}};
  EXPECT_NO_THROW(validate(project));
  EXPECT_NO_THROW(validate_against_blocks(project, {{"slope.1", BodyKind::tetrahedra}, {"top", BodyKind::tetrahedra}}));
}

TEST(BodyRulesOfGoodProjects, AFixedBlockIsShaken) {
  Project project = slope();
  project.blocks[0].body = BodyKind::fixed;
  project.constraints = {{"top", {}, {0, 0, 0}, {{0, {0, 0, 0}}, {1, {0.1, 0, 0}}}}};
  EXPECT_NO_THROW(validate(project));
}

TEST(BodyRulesOfGoodProjects, EveryBodyMayBeAskedFor) {
  for (const BodyKind body : {BodyKind::rigid, BodyKind::affine, BodyKind::automatic}) {
    Project project = slope();
    project.solids[0].body = body;
    project.blocks[0].body = body;
    EXPECT_NO_THROW(validate(project)) << to_string(body);
  }
}

TEST(BodyRulesOfGoodProjects, AnAffineBlockHasStress) {
  Project project = slope();
  project.blocks[0].body = BodyKind::affine;
  project.monitors[0].stress = true;
  project.expect[0].quantity = "P1.stress.zz";
  EXPECT_NO_THROW(validate(project));
}

/// What a block of body 'auto' is built as is known from cutting on.
class BodyRulesOfAuto : public testing::Test {
 protected:
  BodyRulesOfAuto() {
    project.blocks[0].body = BodyKind::automatic;
    project.stages.push_back(project.stages[0]);
    project.stages[1].name = "released";
    project.stages[0].blocks = {{"top", BodyKind::fixed}};
  }
  void let_go_as(BodyKind body) { project.stages[1].blocks = {{"top", body}}; }
  /// The problem once `top` is built so, or nothing.
  std::string problem_when_built_as(BodyKind body) {
    validate(project);
    try {
      validate_against_blocks(project, {{"slope.1", BodyKind::tetrahedra}, {"top", body, true}});
    } catch (const InputError& error) {
      return error.problem() + ": " + error.remedy();
    }
    return "";
  }
  Project project = slope();
};

TEST_F(BodyRulesOfAuto, HeldThroughoutItIsFixed) { EXPECT_EQ(problem_when_built_as(BodyKind::fixed), ""); }

TEST_F(BodyRulesOfAuto, ItIsLetGoAsAutoOrAsWhatItWasBuilt) {
  for (const BodyKind built : {BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra}) {
    let_go_as(BodyKind::automatic);
    EXPECT_EQ(problem_when_built_as(built), "");
    let_go_as(built);
    EXPECT_EQ(problem_when_built_as(built), "");
  }
  let_go_as(BodyKind::affine);
  EXPECT_EQ(
      problem_when_built_as(BodyKind::rigid),
      "block 'top' is built as 'rigid' and cannot become 'affine': use 'fixed' to hold it, or 'auto' to let it go");
}

TEST_F(BodyRulesOfAuto, WhatIsMovedAsAWholeCannotBeLetGo) {
  project.constraints = {Constraint{"top", {}}};
  EXPECT_EQ(problem_when_built_as(BodyKind::fixed), "");
  let_go_as(BodyKind::automatic);
  EXPECT_THAT(problem_when_built_as(BodyKind::fixed), testing::HasSubstr("can neither hold it nor let it go"));
}

TEST_F(BodyRulesOfAuto, AMonitorOfStressFindsItsBlockMeshed) {
  project.monitors[0].stress = true;
  EXPECT_EQ(problem_when_built_as(BodyKind::tetrahedra), "");
  EXPECT_THAT(problem_when_built_as(BodyKind::fixed), testing::HasSubstr("'fixed' and has no stress"));
}

/// Where solids differ, only cutting tells which of them an override's point lies in.
TEST(BodyRulesAgainstBlocks, KnowTheBodiesGeometryGave) {
  Project project = slope();
  Solid ground = project.solids[0];
  ground.name = "ground";
  ground.shape = BoxShape{{20, 0, 0}, {30, 9, 9}};
  ground.body = BodyKind::fixed;
  project.solids.push_back(ground);
  project.constraints = {Constraint{"top", {}}};
  EXPECT_NO_THROW(validate(project));
  EXPECT_NO_THROW(validate_against_blocks(project, {{"slope.1", BodyKind::tetrahedra}, {"top", BodyKind::fixed}}));
  try {
    validate_against_blocks(project, {{"slope.1", BodyKind::tetrahedra}, {"top", BodyKind::tetrahedra}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "/constraints/0");
    EXPECT_THAT(error.problem(), testing::HasSubstr("which is not fixed"));
  }
}

}  // namespace
}  // namespace talus
