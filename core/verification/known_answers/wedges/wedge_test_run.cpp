#include "model/stages.hpp"
#include "verification/known_answers/support/scene.hpp"
#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {

namespace {

constexpr double test_time_step = 1e-3;  // s; a wedge that falls takes 56 of them
constexpr int test_static_steps = 10;
constexpr double longest = 1;  // s; a wedge that has not gone 5 % of its length by then has a factor above 0.99

}  // namespace

CaseScene wedge_test_scene(const WedgeTest& test, double friction_angle, int refinements, double duration) {
  Joint planes;
  planes.name = "planes";
  planes.friction_angle = friction_angle;
  CaseScene scene = wedge_in_mould(test.shape(), test.turn(), plaster(), planes, refinements);
  scene.project.stages = {static_stage(test_time_step, test_static_steps), dynamic_stage(test_time_step, duration)};
  return scene;
}

WedgeMotion run_wedge_test(const WedgeTest& test, double friction_angle, int refinements, const CaseOptions& options,
                           Progress& progress) {
  const CaseScene scene = as_asked(wedge_test_scene(test, friction_angle, refinements, longest), options);
  WedgeWatch watch(scene, turned(test.shape().planes(), test.turn()), test.shape().length() * options.scale);
  const auto look = [&](const Simulation& simulation, const StepReport& report) {
    return watch.look(simulation, report);
  };
  try {
    run_scene(scene, progress, look);
  } catch (const NoAnswer&) {
    WedgeMotion none = watch.motion();
    none.mode.reset();
    none.direction.setZero();
    return none;
  }
  return watch.motion();
}

}  // namespace talus
