// The same slopes with blocks of every rung of the ladder of bodies: the tables of docs/cost.md.
//   OPENBLAS_NUM_THREADS=1 build/release/tests/bench/bench_ladder

#include <array>
#include <vector>

#include "bench/step_costs.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

namespace talus {
namespace {

constexpr int settling_steps = 50;

struct Rung {
  const char* name;
  BodyKind body;
  int cells;  ///< of an edge of 1 m
};
constexpr std::array rungs = {Rung{"rigid", BodyKind::rigid, 1}, Rung{"affine", BodyKind::affine, 1},
                              Rung{"6 tetrahedra", BodyKind::tetrahedra, 1},
                              Rung{"48 tetrahedra", BodyKind::tetrahedra, 2}};

void add(CaseScene& scene, const Vec3& min, const Vec3& sides, const Rung& rung) {
  const int n = rung.cells;
  scene.add_block("block " + std::to_string(scene.system.blocks.size()),
                  box_mesh(min, min + sides, n, n, n * static_cast<int>(sides.z())), rung.body);
}

/// 32 cubes, two layers deep, on a plane.
CaseScene slope(double dip, const Rung& rung) {
  CaseScene scene = rock_scene(30);
  tilt(scene, dip);
  scene.add_fixed_box("slope", Vec3(-1, -1, -1), Vec3(40, 3, 0));
  for (int i = 0; i < 32; ++i) add(scene, Vec3(i % 8, i / 8 % 2, i / 16), Vec3::Ones(), rung);
  return scene;
}

/// 32 cubes with room between them.
CaseScene scattered(double dip, const Rung& rung) {
  CaseScene scene = rock_scene(30);
  tilt(scene, dip);
  scene.add_fixed_box("slope", Vec3(-1, -1, -1), Vec3(40, 7, 0));
  for (int i = 0; i < 32; ++i) add(scene, Vec3(1.5 * (i % 8), 1.5 * (i / 8), 0), Vec3::Ones(), rung);
  return scene;
}

/// 16 columns on a plane, four times as high as wide, with `room` between them [m].
CaseScene columns(double dip, double room, const Rung& rung) {
  CaseScene scene = rock_scene(35);
  tilt(scene, dip);
  scene.add_fixed_box("slope", Vec3(-1, -1, -1), Vec3(40, 2, 0));
  for (int i = 0; i < 16; ++i) add(scene, Vec3((1 + room) * i, 0, 0), Vec3(1, 1, 4), rung);
  return scene;
}

struct Result {
  StepCosts costs;
  std::vector<BlockMotion> blocks;
};

Result measure(CaseScene scene, double duration) {
  scene.project.solver.sleep_tolerance = 0;
  scene.project.stages = {static_stage(0.01, settling_steps), dynamic_stage(0.01, duration)};
  Simulation simulation(scene.project, scene.system);
  for (int i = 0; i < settling_steps; ++i) simulation.step();
  StepCosts costs(simulation);
  while (!simulation.finished()) costs.take_step(simulation);
  costs.finish(simulation);
  if (!simulation.converged()) std::printf("%s\n", simulation.failure().c_str());
  Result result{costs, {}};
  for (int b = 1; b < static_cast<int>(scene.system.blocks.size()); ++b)
    result.blocks.push_back(block_motion(simulation.bodies(), b));
  return result;
}

/// How far the blocks went, and how far from where the finest ones are.
void print_motion(const char* name, const std::vector<BlockMotion>& blocks, const std::vector<BlockMotion>& finest) {
  double mean = 0, farthest = 0, turned = 0, differs = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const double way = blocks[b].displacement.norm();
    mean += way / static_cast<double>(blocks.size());
    farthest = std::max(farthest, way);
    turned = std::max(turned, blocks[b].rotation * 180 / M_PI);
    differs = std::max(differs, (blocks[b].displacement - finest[b].displacement).norm());
  }
  std::printf("| %s | %.6g | %.6g | %.3g | %.2e |\n", name, mean, farthest, turned, differs);
}

void climb(const char* title, double duration, const std::function<CaseScene(const Rung&)>& scene) {
  std::printf("\n%s\n\n", title);
  StepCosts::print_head();
  std::vector<Result> results;
  for (const Rung& rung : rungs) {
    results.push_back(measure(scene(rung), duration));
    results.back().costs.print(rung.name);
  }
  std::printf("\n| bodies | of the step by effect, %% |\n|---|---|\n");
  for (std::size_t r = 0; r < rungs.size(); ++r)
    std::printf("| %s | %s |\n", rungs[r].name, results[r].costs.by_effect().c_str());
  std::printf(
      "\n| bodies | mean displacement, m | longest | largest turn, degrees | farthest from the finest, m |\n"
      "|---|---|---|---|---|\n");
  for (std::size_t r = 0; r < rungs.size(); ++r) print_motion(rungs[r].name, results[r].blocks, results.back().blocks);
  std::fflush(stdout);
}

}  // namespace
}  // namespace talus

int main() {
  using namespace talus;
  climb("32 cubes on a slope of 26.5°, φ 30°: they stand, 1 s", 1, [](const Rung& rung) { return slope(26.5, rung); });
  climb("32 cubes side by side on a slope of 35°, φ 30°, with room between them: they slide, 1 s", 1,
        [](const Rung& rung) { return scattered(35, rung); });
  climb("16 columns of 1 × 1 × 4 m on a slope of 20°, φ 35°, with room between them: they topple, 1 s", 1,
        [](const Rung& rung) { return columns(20, 1, rung); });
  climb("The same in a row that touches: each column leans on the next, 1 s", 1,
        [](const Rung& rung) { return columns(20, 0, rung); });
}
