#include "effects/compose.hpp"

#include <gmock/gmock.h>

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

std::vector<std::string> names(const Composition& composition) {
  std::vector<std::string> list;
  for (const auto& effect : composition.effects) list.emplace_back(effect->name());
  return list;
}

TEST(Compose, a_falling_block_gets_no_contact_no_load_and_no_constraint) {
  const Project project = one_block_project();
  const BlockSystem system = one_block();
  BodySet set(project, system);
  const ContactSet contacts;
  const ContactLinks links(set, contacts);
  const Composition composition = compose(project, system, 0, set, links);
  EXPECT_THAT(names(composition), testing::ElementsAre("elasticity", "inertia", "body force"));
  EXPECT_EQ(composition.shear, nullptr);
}

TEST(Compose, each_element_has_the_law_of_its_rock) {
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
  EXPECT_THAT(names(compose(project, system, 0, set, links)),
              testing::ElementsAre("elasticity", "neo-Hookean elasticity", "inertia", "body force", "normal contact"));
  set.hold({true, false});
  EXPECT_THAT(set.linear, testing::IsEmpty());
  EXPECT_THAT(set.neo_hookean, testing::ElementsAre(0));
}

TEST(Compose, everything_a_scene_calls_for_is_there_once) {
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
  EXPECT_THAT(names(composition),
              testing::ElementsAre("elasticity", "initial stress", "inertia", "displacement constraint", "point load",
                                   "body force", "normal contact", "shear contact", "cohesion and tension", "damping"));
  const auto list = called_effects(project, system);
  const auto bonds =
      std::find_if(list.begin(), list.end(), [](const EffectStatus& s) { return s.name == "cohesion and tension"; });
  ASSERT_NE(bonds, list.end());
  EXPECT_TRUE(bonds->active);
  EXPECT_EQ(bonds->reason, "bonds on J");
}

TEST(Compose, a_frictionless_scene_has_no_shear_contact_and_says_why) {
  Project project = one_block_project();
  project.joints = {{"J", 0, 0, 0, {}, {}, {}, {}}};
  BlockSystem system = one_block();
  system.blocks.push_back(test::box_block("ground", Vec3(0, 0, -1), Vec3(1, 1, 0), BodyKind::fixed));
  const auto list = called_effects(project, system);
  const auto shear =
      std::find_if(list.begin(), list.end(), [](const EffectStatus& s) { return s.name == "shear contact"; });
  ASSERT_NE(shear, list.end());
  EXPECT_FALSE(shear->active);
  EXPECT_EQ(shear->reason, "no joint resists shear");
}

TEST(Compose, blocks_rebound_by_a_law_where_a_restitution_asks_for_it_or_a_rigid_block_may_be_stopped) {
  const auto rebound = [](BodyKind body, StageKind stage, std::optional<double> restitution) {
    Project project = one_block_project();
    project.joints = {{"J", 20, 0, 0, {}, {}, {}, restitution}};
    for (Stage& each : project.stages) each.kind = stage;
    BlockSystem system = one_block();
    system.blocks[0].body = body;
    system.blocks.push_back(test::box_block("ground", Vec3(0, 0, -1), Vec3(1, 1, 0), BodyKind::fixed));
    for (const EffectStatus& status : called_effects(project, system))
      if (status.name == "rebound") return std::pair(status.active, status.reason);
    return std::pair(false, std::string("is not listed"));
  };
  EXPECT_EQ(rebound(BodyKind::tetrahedra, StageKind::dynamic, 0.5), std::pair(true, std::string("restitution of J")));
  EXPECT_EQ(rebound(BodyKind::rigid, StageKind::dynamic, {}),
            std::pair(true, std::string("1 rigid block stays where a contact too stiff for the step stops it")));
  EXPECT_EQ(rebound(BodyKind::tetrahedra, StageKind::dynamic, {}),
            std::pair(false, std::string("no restitution given, and no block is rigid")));
  EXPECT_EQ(rebound(BodyKind::rigid, StageKind::static_, 0.5), std::pair(false, std::string("every stage is static")));
}

TEST(Compose, the_papers_incremental_strain_carries_its_stress) {
  Project project = one_block_project();
  project.solver.strain = Strain::incremental;
  const BlockSystem system = one_block();
  BodySet set(project, system);
  const ContactSet contacts;
  const ContactLinks links(set, contacts);
  EXPECT_THAT(names(compose(project, system, 0, set, links)),
              testing::ElementsAre("elasticity", "initial stress", "inertia", "body force"));
}

TEST(Compose, a_stage_gets_the_loads_that_it_names_and_no_others) {
  Project project = one_block_project();
  project.loads = {{"B", Vec3(0.5, 0.5, 0.5), Vec3(1, 0, 0)}};
  project.stages.resize(2);
  project.stages[1].loads.emplace();
  const BlockSystem system = one_block();
  BodySet set(project, system);
  const ContactSet contacts;
  const ContactLinks links(set, contacts);
  EXPECT_THAT(names(compose(project, system, 0, set, links)), testing::Contains("point load"));
  EXPECT_THAT(names(compose(project, system, 1, set, links)), testing::Not(testing::Contains("point load")));
}

TEST(Compose, a_load_outside_its_block_is_an_error_that_names_the_load) {
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
