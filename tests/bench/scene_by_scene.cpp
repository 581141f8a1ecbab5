// What each thing that a scene calls for adds to a step: the tables of docs/cost.md.
//   OPENBLAS_NUM_THREADS=1 build/release/tests/bench/bench_scene_by_scene

#include <filesystem>
#include <memory>
#include <vector>

#include "bench/step_costs.hpp"
#include "model/stages.hpp"
#include "run/run.hpp"
#include "verification/known_answers/support/scene.hpp"

namespace talus {
namespace {

constexpr double time_step = 1e-3;  // s
constexpr int settling_steps = 30, falling_asleep = 60, measured = 1000;

/// What a scene calls for. A block of 1 m falls, or slides down a plane of 30° that is there, past bystanders at rest.
struct Calls {
  std::string name;
  BodyKind body = BodyKind::rigid;
  bool ground = true;
  double friction_angle = 20, cohesion = 0;
  int bystanders = 0;
  bool sleep = true;
  int cells = 1;  ///< of an edge of the block
};

CaseScene scene_of(const Calls& calls) {
  CaseScene scene = rock_scene(calls.friction_angle);
  scene.project.joints[0].cohesion = calls.cohesion;
  scene.project.solver.sleep_tolerance = calls.sleep ? 1e-9 : 0.0;
  scene.project.output.every = 1e9;
  tilt(scene, 30);
  const double height = calls.ground ? 0 : 10;
  scene.add_block("block",
                  box_mesh(Vec3(0, -3, height), Vec3(1, -2, 1 + height), calls.cells, calls.cells, calls.cells),
                  calls.body);
  if (calls.ground) scene.add_block("plane", box_mesh(Vec3(-2, -5, -1), Vec3(100, 100, 0), 2, 2, 1), BodyKind::fixed);
  if (calls.bystanders > 0) scene.add_joint({"rough", 40, 0, 0, {}, {}, {}, {}});
  for (int i = 0; i < calls.bystanders; ++i) {
    const std::string name = "bystander " + std::to_string(i + 1);
    const Vec3 corner(3 * (i % 32), 3 * (i / 32), 0);
    scene.add_block(name, box_mesh(corner, corner + Vec3::Ones(), 1, 1, 1), BodyKind::affine);
    scene.project.interfaces.push_back({{"plane", name}, "rough"});
  }
  Stage settle = static_stage(time_step, settling_steps);
  settle.blocks = {{"block", BodyKind::fixed}};
  Stage move = dynamic_stage(time_step, time_step * (falling_asleep + measured));
  move.blocks = {{"block", calls.body}};
  scene.project.stages = {settle, move};
  return scene;
}

StepCosts measure(const Calls& calls) {
  const CaseScene scene = scene_of(calls);
  Simulation simulation(scene.project, scene.system);
  for (int i = 0; i < settling_steps + falling_asleep; ++i) simulation.step();
  StepCosts costs(simulation);
  while (!simulation.finished()) costs.take_step(simulation);
  costs.finish(simulation);
  if (!simulation.converged()) std::printf("%s: %s\n", calls.name.c_str(), simulation.failure().c_str());
  return costs;
}

/// Processor time of a whole run from the end of one step to the end of another.
class Clock final : public RunObserver {
 public:
  void on_step(const StepReport& step, const HistoryRow&, double) override {
    if (step.step == settling_steps + falling_asleep) begin_ = std::clock();
    if (step.step == settling_steps + falling_asleep + measured - 1) end_ = std::clock();
  }
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override { return true; }
  double microseconds() const { return 1e6 * static_cast<double>(end_ - begin_) / CLOCKS_PER_SEC / (measured - 1); }

 private:
  std::clock_t begin_ = 0, end_ = 0;
};

double microseconds_of_run(const Calls& calls) {
  const CaseScene scene = scene_of(calls);
  const auto folder = std::filesystem::temp_directory_path() / "talus_scene_by_scene";
  Clock clock;
  run(scene.project, scene.system, {folder, "{}", 1}, clock);
  std::filesystem::remove_all(folder);
  return clock.microseconds();
}

/// Best of three, in turns: what else the machine does is not the scene's cost.
void compare(const char* name, const Calls& without, const Calls& with) {
  double step[2] = {1e9, 1e9}, whole[2] = {1e9, 1e9};
  for (int turn = 0; turn < 3; ++turn) {
    for (int k = 0; k < 2; ++k) {
      step[k] = std::min(step[k], measure(k ? with : without).microseconds());
      whole[k] = std::min(whole[k], microseconds_of_run(k ? with : without));
    }
  }
  std::printf("| %s | %.1f | %.1f | %.2f | %.1f | %.1f | %.2f |\n", name, step[0], step[1], step[1] / step[0], whole[0],
              whole[1], whole[1] / whole[0]);
  std::fflush(stdout);
}

void measure_all() {
  const std::vector<Calls> scenes = {
      {.name = "a rigid block falls", .ground = false, .friction_angle = 0},
      {.name = "+ a plane that it slides on", .friction_angle = 0},
      {.name = "+ friction, 20°"},
      {.name = "+ cohesion that holds it, 10 kPa", .cohesion = 1e4, .sleep = false},
      {.name = "friction, and the block is affine", .body = BodyKind::affine},
      {.name = "of 6 tetrahedra", .body = BodyKind::tetrahedra},
      {.name = "of 162 tetrahedra", .body = BodyKind::tetrahedra, .cells = 3},
      {.name = "rigid, + 100 bystanders at rest, awake", .bystanders = 100, .sleep = false},
      {.name = "rigid, + 100 asleep", .bystanders = 100},
      {.name = "rigid, + 1 000 asleep", .bystanders = 1000},
      {.name = "of 162 tetrahedra, + 1 000 asleep", .body = BodyKind::tetrahedra, .bystanders = 1000, .cells = 3}};
  StepCosts::print_head();
  std::vector<std::string> by_effect;
  for (const Calls& scene : scenes) {
    StepCosts costs = measure(scene);
    for (int again = 0; again < 2; ++again) costs.take_least(measure(scene));
    costs.print(scene.name);
    by_effect.push_back("| " + scene.name + " | " + costs.by_effect() + " |");
  }
  std::printf("\n| scene | of the step by effect, %% |\n|---|---|\n");
  for (const std::string& row : by_effect) std::printf("%s\n", row.c_str());
  std::printf(
      "\n| beside 1 000 sleepers | µs a step without | with | ratio | of a whole run without | with | ratio |\n"
      "|---|---|---|---|---|---|---|\n");
  compare("a rigid block slides", {.name = ""}, {.name = "", .bystanders = 1000});
  compare("an affine block slides", {.name = "", .body = BodyKind::affine},
          {.name = "", .body = BodyKind::affine, .bystanders = 1000});
  compare("a block of 162 tetrahedra slides", {.name = "", .body = BodyKind::tetrahedra, .cells = 3},
          {.name = "", .body = BodyKind::tetrahedra, .bystanders = 1000, .cells = 3});
}

}  // namespace
}  // namespace talus

int main() { talus::measure_all(); }
