// Contact by area and the paper's facet-wise common plane on the same scenes: the table of docs/contact.md.
//   OPENBLAS_NUM_THREADS=1 build/release/tests/bench/bench_contact_models

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/support/scene.hpp"
#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {
namespace {

constexpr double g = 9.81;

/// A scene, the normals that its smooth bodies have, and what its first moving block should do.
struct Trial {
  std::string name;
  CaseScene scene;
  std::vector<Vec3> normals;
  std::string block;
  Vec3 expected = Vec3::Zero();  ///< m/s at the end
};

Stage moving(double time_step, double duration) {
  Stage stage = dynamic_stage(time_step, duration);
  stage.name = "slide";
  return stage;
}

/// A cube of 3 × 3 × 3 cells with its lower corner at `min`.
void add_cube(CaseScene& scene, const std::string& name, const Vec3& min, bool mirrored) {
  scene.add_block(name, box_mesh(min, min + Vec3(1, 1, 1), 3, 3, 3, mirrored), BodyKind::tetrahedra);
}

CaseScene ground_and_cube(double friction_angle) {
  CaseScene scene = rock_scene(friction_angle);
  scene.project.gravity = Vec3(0, 0, -g);
  scene.add_block("ground", box_mesh({0, 0, -1}, {6, 5, 0}, 8, 7, 1), BodyKind::fixed);
  add_cube(scene, "cube", {0.6, 0.6, 0}, true);
  return scene;
}

void push(CaseScene& scene, const Vec3& velocity, double duration) {
  scene.project.velocities.push_back({"cube", velocity, Vec3::Zero()});
  scene.project.stages = {static_stage(2e-3, 20), moving(2e-3, duration)};
}

Trial over_a_mesh() {
  Trial t{"frictionless, over a plane's mesh", ground_and_cube(0), {Vec3::UnitZ()}, "cube"};
  t.expected = Vec3(1, 0.3, 0);
  push(t.scene, t.expected, 2);
  return t;
}

Trial over_a_seam() {
  Trial t{"frictionless, over the joint of two flush slabs", rock_scene(0), {Vec3::UnitZ()}, "cube"};
  t.scene.project.gravity = Vec3(0, 0, -g);
  t.scene.add_block("slab", box_mesh({0, 0, -1}, {2.5, 3, 0}, 4, 4, 1), BodyKind::fixed);
  t.scene.add_block("next slab", box_mesh({2.5, 0, -1}, {6, 3, 0}, 5, 3, 1), BodyKind::fixed);
  add_cube(t.scene, "cube", {0.6, 0.7, 0}, true);
  t.expected = Vec3(1, 0.3, 0);
  push(t.scene, t.expected, 2);
  return t;
}

/// A V of 90° along x of two planes whose meshes do not match, and a cube in it.
Trial in_a_groove() {
  const double s = std::sqrt(0.5);
  Trial t{"frictionless, along a groove of two planes", rock_scene(0), {Vec3(0, -s, s), Vec3(0, s, s)}, "cube"};
  t.scene.project.gravity = Vec3(0, 0, -g);
  const auto side = [&](double y0, double y1) {
    return std::array<Vec3, 8>{Vec3(0, y0, -1),           Vec3(5, y0, -1),           Vec3(0, y1, -1),
                               Vec3(5, y1, -1),           Vec3(0, y0, std::abs(y0)), Vec3(5, y0, std::abs(y0)),
                               Vec3(0, y1, std::abs(y1)), Vec3(5, y1, std::abs(y1))};
  };
  t.scene.add_block("right", hexahedron_mesh(side(0, 2), 9, 4, 1), BodyKind::fixed);
  t.scene.add_block("left", hexahedron_mesh(side(-2, 0), 7, 3, 1), BodyKind::fixed);
  std::array<Vec3, 8> corners;
  for (int k = 0; k < 8; ++k) {
    const double x = k & 1, y = k >> 1 & 1, z = k >> 2 & 1;
    corners[k] = Vec3(0.6 + x, s * (y - z), s * (y + z));
  }
  t.scene.add_block("cube", hexahedron_mesh(corners, 3, 3, 3, true), BodyKind::tetrahedra);
  t.expected = Vec3(1, 0, 0);
  push(t.scene, t.expected, 2);
  return t;
}

/// On a plane of 30°, downhill 37° off the mesh's axis.
Trial on_an_incline(double friction_angle, double duration) {
  const double acceleration =
      std::max(0.0, g * (std::sin(radians(30)) - std::tan(radians(friction_angle)) * std::cos(radians(30))));
  const Vec3 downhill(std::cos(radians(37)), std::sin(radians(37)), 0);
  Trial t{acceleration > 0 ? "slides down 30°, φ 20°" : "sticks at 30°, φ 35°",
          ground_and_cube(friction_angle),
          {Vec3::UnitZ()},
          "cube"};
  t.scene.project.gravity = g * (std::sin(radians(30)) * downhill - std::cos(radians(30)) * Vec3::UnitZ());
  t.scene.project.stages = {moving(2e-3, duration)};
  t.expected = acceleration * duration * downhill;
  return t;
}

Trial column() {
  Trial t{"column of five cubes at rest", rock_scene(30), {Vec3::UnitZ()}, "cube 5"};
  t.scene.project.gravity = Vec3(0, 0, -g);
  t.scene.add_block("ground", box_mesh({0, 0, -1}, {3, 3, 0}, 4, 4, 1), BodyKind::fixed);
  for (int i = 0; i < 5; ++i) add_cube(t.scene, "cube " + std::to_string(i + 1), Vec3(1, 1, i), i % 2);
  t.scene.project.stages = {static_stage(2e-3, 50), moving(2e-3, 0.6)};
  return t;
}

bool is_false(const Trial& trial, const Vec3& normal) {
  return std::none_of(trial.normals.begin(), trial.normals.end(),
                      [&](const Vec3& n) { return std::abs(n.dot(normal)) > std::cos(radians(1)); });
}

struct Sums {
  int steps = 0, cuts = 0;
  long contacts = 0, iterations = 0, false_listed = 0, false_pushing = 0;
  double detect = 0, all = 0, processor = 0;
};

void run(Trial trial, ContactModel model) {
  trial.scene.project.solver.contact = model;
  Sums sums;
  Vec3 velocity = Vec3::Zero();
  NoProgress progress;
  std::string end;
  int number = 0;
  while (trial.scene.system.blocks[number].name != trial.block) ++number;
  std::clock_t before = std::clock();  // processor time: the machine may be busy
  try {
    run_scene(trial.scene, progress, [&](const Simulation& simulation, const StepReport& report) {
      sums.processor += static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
      ++sums.steps;
      sums.cuts += report.cuts;
      sums.iterations += report.iterations;
      sums.contacts += report.contacts;
      const Phases& p = report.phases;
      sums.detect += p.detect;
      sums.all += p.detect + p.assemble + p.factor + p.solve + p.update;
      for (const ContactSample& c : simulation.contacts()) {
        if (!is_false(trial, c.normal)) continue;
        ++sums.false_listed;
        sums.false_pushing += c.normal_force > 0;
      }
      velocity = block_motion(simulation.bodies(), number).velocity;
      end = std::to_string(simulation.time());
      before = std::clock();
      return true;
    });
    end.clear();
  } catch (const std::exception& error) {
    end = " (ended after " + end + " s: " + error.what() + ")";
  }
  const double n = sums.steps;
  std::printf("| %s | %s%s | %.2e | %.2f, %ld | %.0f | %.2f, %d | %.2f, %.0f %% |\n", trial.name.c_str(),
              std::string(to_string(model)).c_str(), end.c_str(), (velocity - trial.expected).norm(),
              sums.false_listed / n, sums.false_pushing, sums.contacts / n, sums.iterations / n, sums.cuts,
              1e3 * sums.processor / n, 100 * sums.detect / sums.all);
  std::fflush(stdout);
}

/// The 65 wedge tests: how many of those off the thresholds move as limit equilibrium says.
void run_wedges(int refinements, ContactModel model) {
  int rows = 0, right = 0, failed = 0;
  double stray = 0;
  NoProgress progress;
  const std::clock_t before = std::clock();
  for (const WedgeTest& test : wedge_tests()) {
    const WedgeEquilibrium equilibrium = test.equilibrium();
    if (at_threshold(equilibrium.factor(plaster_friction_angle))) continue;
    ++rows;
    CaseScene scene = wedge_test_scene(test, plaster_friction_angle, refinements, 1);
    scene.project.solver.contact = model;
    WedgeWatch watch(scene, turned(test.shape().planes(), test.turn()), test.shape().length());
    try {
      run_scene(scene, progress,
                [&](const Simulation& simulation, const StepReport& report) { return watch.look(simulation, report); });
      right += watch.motion().mode == equilibrium.mode(plaster_friction_angle);
      stray += watch.motion().stray;
    } catch (const std::exception&) {
      ++failed;
    }
  }
  std::printf("| %d | %s | %d of %d | %d | %.1e | %.1f |\n", 1 << 3 * refinements,
              std::string(to_string(model)).c_str(), right, rows, failed, stray / rows,
              static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  std::fflush(stdout);
}

}  // namespace
}  // namespace talus

int main() {
  using namespace talus;
  std::printf(
      "| scene | model | error of the velocity at the end, m/s | false normals a step, of them pushing in all | "
      "contacts "
      "| iterations a step, cuts | ms a step, of it detection |\n|---|---|---|---|---|---|---|\n");
  const std::function<Trial()> trials[] = {over_a_mesh,
                                           over_a_seam,
                                           in_a_groove,
                                           [] { return on_an_incline(20, 1.2); },
                                           [] { return on_an_incline(35, 1.2); },
                                           column};
  for (const auto& trial : trials) {
    for (ContactModel model : {ContactModel::area, ContactModel::facet_wise}) run(trial(), model);
  }
  std::printf(
      "\n| wedge tests, tetrahedra | model | mode of limit equilibrium, off the thresholds | did not converge | normal "
      "force on neither plane, share | s |\n|---|---|---|---|---|---|\n");
  for (int refinements : {0, 1}) {
    for (ContactModel model : {ContactModel::area, ContactModel::facet_wise}) run_wedges(refinements, model);
  }
}
