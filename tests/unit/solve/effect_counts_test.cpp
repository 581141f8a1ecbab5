// What a scene does not call for is built zero times and evaluated zero times: counts, not times.
#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <set>

#include "mesh/structured_mesh.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

struct CountedScene {
  Project project;
  BlockSystem system = test::cube_on_slab();
};

/// A scene that calls for every effect there is.
CountedScene with_everything() {
  CountedScene scene;
  scene.project =
      test::rock_project(30, {{"stand", StageKind::static_, 0.01, 3, {}}, {"move", StageKind::dynamic, 0.01, 5, {}}});
  scene.project.joints[0].cohesion = 1e4;
  scene.project.joints[0].restitution = 0.5;
  scene.project.materials[0].damping = 0.5;
  scene.project.materials.push_back({"soft", 1000, 1e6, 0.3, 0, MaterialLaw::neo_hookean});
  scene.system.blocks.push_back(scene.system.blocks[1]);
  scene.system.blocks[2].name = "soft";
  scene.system.blocks[2].material = 1;
  scene.system.blocks[2].body = BodyKind::affine;
  for (Vec3& node : scene.system.blocks[2].mesh.nodes) node.z() += 5;
  scene.project.loads = {{"B", Vec3(0.5, 0.5, 0.5), Vec3(10, 0, 0)}};
  scene.project.constraints = {{"B", Vec3(0.2, 0.2, 0.2), {{0.0, {}, {}}}}};
  scene.project.in_situ.emplace_back();
  scene.project.in_situ[0].stress << 0, 0, -1e4, 0, 0, 0;
  return scene;
}

std::vector<EffectOutcome> effects_after_run(const CountedScene& scene) {
  Simulation simulation(scene.project, scene.system);
  while (!simulation.finished()) simulation.step();
  EXPECT_TRUE(simulation.converged()) << simulation.failure();
  return simulation.effects();
}

const EffectOutcome& of_name(const std::vector<EffectOutcome>& effects, const std::string& name) {
  const auto found = std::find_if(effects.begin(), effects.end(), [&](const auto& e) { return e.name == name; });
  EXPECT_NE(found, effects.end()) << name;
  return *found;
}

/// Laws and what goes beyond the equations are no terms of a stage: they are there for all stages.
long times_built(const EffectOutcome& effect) {
  static const std::set<std::string> for_all_stages{
      "rebound",          "restitution",        "missed contacts", "updated normals",      "penalty scaling",
      "followed springs", "acceleration reset", "sleep",           "nonlinear elimination"};
  return for_all_stages.contains(effect.name) ? 1 : 2;
}

/// In a run of easy steps no block is ever balanced by itself, and what a bond holds does not part: these may be idle.
bool is_surely_evaluated(const EffectOutcome& effect) {
  return effect.name != "nonlinear elimination" && effect.name != "restitution";
}

TEST(EffectCounts, EveryEffectThatIsCalledForIsBuiltOnceAStageAndEvaluated) {
  const auto effects = effects_after_run(with_everything());
  EXPECT_EQ(effects.size(), 20u);
  for (const EffectOutcome& effect : effects) {
    EXPECT_TRUE(effect.active) << effect.name;
    EXPECT_EQ(effect.built, times_built(effect)) << effect.name;
    if (is_surely_evaluated(effect)) {
      EXPECT_GT(effect.evaluations, 0) << effect.name;
    }
  }
  EXPECT_GT(of_name(effects, "elasticity").assemblies, 0);
  EXPECT_EQ(of_name(effects, "inertia").assemblies, 2) << "its matrix stays the same through a stage";
}

TEST(EffectCounts, WhatIsNotCalledForIsNeverBuiltAndNeverEvaluated) {
  struct Without {
    std::string effect;
    std::function<void(CountedScene&)> take_away;
    std::vector<std::string> with_it{};  ///< what goes along
  };
  const std::vector<Without> scenes{
      {"elasticity", [](CountedScene& s) { s.system.blocks[1].body = BodyKind::rigid; }},
      {"neo-Hookean elasticity", [](CountedScene& s) { s.project.materials[1].law = MaterialLaw::linear; }},
      {"initial stress", [](CountedScene& s) { s.project.in_situ.clear(); }},
      {"displacement constraint", [](CountedScene& s) { s.project.constraints.clear(); }},
      {"point load", [](CountedScene& s) { s.project.loads.clear(); }},
      {"body force", [](CountedScene& s) { s.project.gravity.setZero(); }},
      {"normal contact",
       [](CountedScene& s) { s.system.blocks = {s.system.blocks[1]}; },
       {"neo-Hookean elasticity", "shear contact", "cohesion and tension", "rebound", "restitution", "missed contacts",
        "updated normals", "penalty scaling", "followed springs", "nonlinear elimination"}},
      {"shear contact", [](CountedScene& s) { s.project.joints[0] = {"J", 0, 0, 1e4, {}, {}, {}, 0.5}; }},
      {"cohesion and tension", [](CountedScene& s) { s.project.joints[0].cohesion = 0; }},
      {"rebound", [](CountedScene& s) { s.project.solver.effects.rebound = Switch::off; }, {"restitution"}},
      {"restitution", [](CountedScene& s) { s.project.joints[0].restitution.reset(); }},
      {"sleep", [](CountedScene& s) { s.project.solver.sleep_tolerance = 0; }},
      {"acceleration reset", [](CountedScene& s) { s.project.solver.integrator = Integrator::generalized_alpha; }},
      {"penalty scaling", [](CountedScene& s) { s.project.joints[0].normal_stiffness = 1e10; }, {"followed springs"}},
      {"missed contacts", [](CountedScene& s) { s.project.solver.contact = ContactModel::facet_wise; }},
      {"damping", [](CountedScene& s) { s.project.materials[0].damping = 0; }},
      {"inertia",
       [](CountedScene& s) {
         s.system.blocks[1].body = s.system.blocks[2].body = BodyKind::fixed;
         s.project.loads.clear();
         s.project.constraints.clear();
       },
       {"elasticity", "neo-Hookean elasticity", "initial stress", "displacement constraint", "point load", "body force",
        "normal contact", "shear contact", "cohesion and tension", "rebound", "damping", "restitution",
        "missed contacts", "updated normals", "penalty scaling", "followed springs", "acceleration reset", "sleep",
        "nonlinear elimination"}}};
  for (const Without& without : scenes) {
    CountedScene scene = with_everything();
    without.take_away(scene);
    for (const EffectOutcome& effect : effects_after_run(scene)) {
      const bool off = effect.name == without.effect ||
                       std::find(without.with_it.begin(), without.with_it.end(), effect.name) != without.with_it.end();
      const std::string place = effect.name + " in a scene without " + without.effect + ": " + effect.reason;
      EXPECT_EQ(effect.active, !off) << place;
      EXPECT_FALSE(effect.reason.empty()) << place;
      EXPECT_EQ(effect.built, off ? 0 : times_built(effect)) << place;
      if (off || is_surely_evaluated(effect)) {
        EXPECT_EQ(effect.evaluations > 0, !off) << place;
      }
      if (!off) continue;
      EXPECT_EQ(effect.assemblies, 0) << place;
      EXPECT_EQ(effect.seconds, 0) << place;
    }
  }
}

TEST(EffectCounts, EffectOfOneStageIsBuiltForThatStageAlone) {
  CountedScene scene = with_everything();
  scene.project.stages[1].loads.emplace();
  EXPECT_EQ(of_name(effects_after_run(scene), "point load").built, 1);
}

TEST(EffectCounts, SceneWithoutContactFactorsOnceInAWholeRun) {
  for (const BodyKind body : {BodyKind::tetrahedra, BodyKind::rigid}) {
    CountedScene scene;
    scene.project = test::rock_project(30, {{"fall", StageKind::dynamic, 0.01, 40, {}}});
    Block& block = scene.system.blocks[1];
    block.body = body;
    block.mesh = box_mesh(Vec3(0, 0, 0), Vec3(1, 1, 1), 2, 2, 2);
    block.surface = boundary(block.mesh);
    scene.system.blocks.erase(scene.system.blocks.begin());
    Simulation simulation(scene.project, scene.system);
    while (!simulation.finished()) simulation.step();
    EXPECT_EQ(simulation.work().factorisations + simulation.work().dense_factorisations, 1) << to_string(body);
    EXPECT_EQ(simulation.work().contact_points, 0);
    EXPECT_EQ(simulation.work().largest_system, body == BodyKind::rigid ? 2 : 27);
  }
}

TEST(EffectCounts, StressIsRecoveredOnlyForFramesAndForThoseWhoWatchIt) {
  CountedScene scene = with_everything();
  scene.project.monitors = {{"P", "B", Vec3(0.5, 0.5, 0.5)}};
  Simulation simulation(scene.project, scene.system);
  for (int i = 0; i < 3; ++i) {
    simulation.step();
    simulation.history();
  }
  EXPECT_EQ(simulation.work().stress_recoveries, 0);
  simulation.frame(0);
  EXPECT_EQ(simulation.work().stress_recoveries, 2) << "of two blocks";
  scene.project.monitors[0].stress = true;
  Simulation watched(scene.project, scene.system);
  watched.step();
  const HistoryRow row = watched.history();
  EXPECT_EQ(watched.work().stress_recoveries, 2);
  ASSERT_TRUE(row.monitors[0].stress);
  EXPECT_LT((*row.monitors[0].stress)[2], 0) << "it is pressed";
}

}  // namespace
}  // namespace talus
