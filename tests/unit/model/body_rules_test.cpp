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
     "/stages/0/blocks/0/name", "'top' is built fixed", "build it as 'tetrahedra', and hold it"},
    {"another kind",
     [](Project& p) {
       p.stages[0].blocks = {{"top", BodyKind::affine}};
     },
     "/stages/0/blocks/0/body", "built as 'tetrahedra' and cannot become 'affine'", "'fixed' to hold it"},
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
