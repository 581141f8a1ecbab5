#include "effects/compose.hpp"

#include <gmock/gmock.h>

#include <set>

#include "base/error.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

Project one_block_project() {
  Project project;
  project.materials = {{"rock", 2600, 25e9, 0.24}};
  project.stages = {{"fall", StageKind::dynamic, 0.01, 10, {}}};
  return project;
}

BlockSystem one_block() {
  BlockSystem system;
  system.blocks = {test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))};
  return system;
}

std::vector<EffectKind> kinds(const Composition& composition) {
  std::vector<EffectKind> list;
  for (const auto& effect : composition.effects) list.push_back(effect->kind());
  return list;
}

TEST(Compose, AFallingBlockGetsNoContactNoLoadAndNoConstraint) {
  const Project project = one_block_project();
  const BlockSystem system = one_block();
  BodySet set(project, system);
  const ContactSet contacts;
  const ContactLinks links(set, contacts);
  const Composition composition = compose(project, system, 0, set, links);
  EXPECT_THAT(kinds(composition),
              testing::ElementsAre(EffectKind::elasticity, EffectKind::inertia, EffectKind::body_force));
  EXPECT_EQ(composition.shear, nullptr);
}

TEST(Compose, EachElementHasTheLawOfItsRock) {
  Project project = one_block_project();
  project.materials.push_back({"soft", 1000, 1e5, 0.4, 0, MaterialLaw::neo_hookean});
  BlockSystem system = one_block();
  system.blocks.push_back(test::box_block("soft", Vec3(5, 0, 0), Vec3(6, 1, 1), BodyKind::affine));
  system.blocks[1].material = 1;
  BodySet set(project, system);
  EXPECT_THAT(set.linear, testing::ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(set.neo_hookean, testing::ElementsAre(6));
  const ContactSet contacts;
  const ContactLinks links(set, contacts);
  EXPECT_THAT(kinds(compose(project, system, 0, set, links)),
              testing::ElementsAre(EffectKind::elasticity, EffectKind::neo_hookean_elasticity, EffectKind::inertia,
                                   EffectKind::body_force, EffectKind::normal_contact));
  set.hold({true, false});
  EXPECT_THAT(set.linear, testing::IsEmpty());
  EXPECT_THAT(set.neo_hookean, testing::ElementsAre(0));
}

TEST(Compose, EverythingASceneCallsForIsThereOnce) {
  Project project = one_block_project();
  project.joints = {{"J", 20, 1e5, 0, {}, {}, {}, {}}};
  project.loads = {{"B", Vec3(0.5, 0.5, 0.5), Vec3(1, 0, 0)}};
  project.constraints = {{"B", Vec3(0.2, 0.2, 0.2), {{0.0, {}, 0.0}}}};
  project.in_situ.emplace_back();
  project.materials[0].damping = 0.5;
  BlockSystem system = one_block();
  system.blocks.push_back(test::box_block("ground", Vec3(0, 0, -1), Vec3(1, 1, 0), BodyKind::fixed));
  BodySet set(project, system);
  const ContactSet contacts;
  const ContactLinks links(set, contacts);
  const Composition composition = compose(project, system, 0, set, links);
  EXPECT_THAT(kinds(composition),
              testing::ElementsAre(EffectKind::elasticity, EffectKind::initial_stress, EffectKind::inertia,
                                   EffectKind::displacement_constraint, EffectKind::point_load, EffectKind::body_force,
                                   EffectKind::normal_contact, EffectKind::shear_contact,
                                   EffectKind::cohesion_and_tension, EffectKind::damping));
  const auto list = called_effects(project, system);
  const auto bonds = std::find_if(list.begin(), list.end(),
                                  [](const EffectStatus& s) { return s.kind == EffectKind::cohesion_and_tension; });
  ASSERT_NE(bonds, list.end());
  EXPECT_TRUE(bonds->active);
  EXPECT_EQ(bonds->reason, "bonds on J");
}

TEST(Compose, EveryKindOfEffectIsListedOnceUnderANameOfItsOwn) {
  const auto list = called_effects(one_block_project(), one_block());
  std::set<EffectKind> kinds;
  std::set<std::string_view> names;
  for (const EffectStatus& status : list) {
    kinds.insert(status.kind);
    names.insert(to_string(status.kind));
  }
  EXPECT_EQ(list.size(), static_cast<std::size_t>(effect_kinds));
  for (std::size_t i = 0; i < list.size(); ++i) EXPECT_EQ(static_cast<std::size_t>(list[i].kind), i) << "in order";
  EXPECT_EQ(kinds.size(), list.size());
  EXPECT_EQ(names.size(), list.size());
}

TEST(Compose, AFrictionlessSceneHasNoShearContactAndSaysWhy) {
  Project project = one_block_project();
  project.joints = {{"J", 0, 0, 0, {}, {}, {}, {}}};
  BlockSystem system = one_block();
  system.blocks.push_back(test::box_block("ground", Vec3(0, 0, -1), Vec3(1, 1, 0), BodyKind::fixed));
  const auto list = called_effects(project, system);
  const auto shear =
      std::find_if(list.begin(), list.end(), [](const EffectStatus& s) { return s.kind == EffectKind::shear_contact; });
  ASSERT_NE(shear, list.end());
  EXPECT_FALSE(shear->active);
  EXPECT_EQ(shear->reason, "no joint resists shear");
}

TEST(Compose, BlocksThatMayTouchInDynamicStagesReboundByALaw) {
  const auto rebound = [](BodyKind body, StageKind stage, std::optional<double> restitution) {
    Project project = one_block_project();
    project.joints = {{"J", 20, 0, 0, {}, {}, {}, restitution}};
    for (Stage& each : project.stages) each.kind = stage;
    BlockSystem system = one_block();
    system.blocks[0].body = body;
    system.blocks.push_back(test::box_block("ground", Vec3(0, 0, -1), Vec3(1, 1, 0), BodyKind::fixed));
    for (const EffectStatus& status : called_effects(project, system))
      if (status.kind == EffectKind::rebound) return std::pair(status.active, status.reason);
    return std::pair(false, std::string("is not listed"));
  };
  EXPECT_EQ(rebound(BodyKind::tetrahedra, StageKind::dynamic, 0.5), std::pair(true, std::string("restitution of J")));
  for (const BodyKind body : {BodyKind::rigid, BodyKind::tetrahedra})
    EXPECT_EQ(rebound(body, StageKind::dynamic, {}),
              std::pair(true, std::string("a contact too stiff for the step throws no block back")));
  EXPECT_EQ(rebound(BodyKind::rigid, StageKind::static_, 0.5), std::pair(false, std::string("every stage is static")));
}

TEST(Compose, ThePapersIncrementalStrainCarriesItsStress) {
  Project project = one_block_project();
  project.solver.strain = Strain::incremental;
  const BlockSystem system = one_block();
  BodySet set(project, system);
  const ContactSet contacts;
  const ContactLinks links(set, contacts);
  EXPECT_THAT(kinds(compose(project, system, 0, set, links)),
              testing::ElementsAre(EffectKind::elasticity, EffectKind::initial_stress, EffectKind::inertia,
                                   EffectKind::body_force));
}

TEST(Compose, AStageGetsTheLoadsThatItNamesAndNoOthers) {
  Project project = one_block_project();
  project.loads = {{"B", Vec3(0.5, 0.5, 0.5), Vec3(1, 0, 0)}};
  project.stages.resize(2);
  project.stages[1].loads.emplace();
  const BlockSystem system = one_block();
  BodySet set(project, system);
  const ContactSet contacts;
  const ContactLinks links(set, contacts);
  EXPECT_THAT(kinds(compose(project, system, 0, set, links)), testing::Contains(EffectKind::point_load));
  EXPECT_THAT(kinds(compose(project, system, 1, set, links)), testing::Not(testing::Contains(EffectKind::point_load)));
}

TEST(Compose, ALoadOutsideItsBlockIsAnErrorThatNamesTheLoad) {
  Project project = one_block_project();
  project.loads = {{"B", Vec3(0.5, 0.5, 0.5), Vec3(1, 0, 0)}, {"B", Vec3(3, 0.5, 0.5), Vec3(1, 0, 0)}};
  const BlockSystem system = one_block();
  BodySet set(project, system);
  const ContactSet contacts;
  const ContactLinks links(set, contacts);
  try {
    compose(project, system, 0, set, links);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "/loads/1");
  }
  project.stages[0].loads = project.loads;
  try {
    compose(project, system, 0, set, links);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "/stages/0/loads/1");
  }
}

}  // namespace
}  // namespace talus
