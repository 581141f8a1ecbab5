// Crowds of blocks, Bullet beside: the table of docs/cost.md, "Crowds".
//   OPENBLAS_NUM_THREADS=1 build/release/tests/bench/bench_crowds [--large] [--tolerance T] [--seconds S] [NAME…]
// Without names all crowds that a step of which takes no minute; with --large also those of thousands of blocks.
// Milliseconds are the processor's, but for the column of two threads, which divides wall times of the same steps.
// Below the table stands how the time of a step grows with the number of blocks, for each kind of crowd.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "bench/crowd_scenes.hpp"
#include "geometry/block_builder.hpp"
#include "io/project_file.hpp"
#include "model/stages.hpp"
#include "model/tolerance_text.hpp"
#include "solve/simulation.hpp"
#include "verification/known_answers/support/scene.hpp"
#if TALUS_HAS_BULLET
#include "bench/bullet_world.hpp"
#endif

namespace talus {
namespace {

/// A scene that is measured.
struct Entry {
  std::string name{};  ///< as on the command line: "slope_12"
  std::string title{};
  std::string kind{};  ///< crowds of one kind differ in their number of blocks alone; empty: it stands alone
  bool large = false;
  std::function<CaseScene()> build{};
  int skip = 0;    ///< steps before those that count
  int steps = 20;  ///< that count, at most
  bool sleeps = false;
  bool beside_bullet = true;
};

CaseScene built(Project project, const std::filesystem::path& folder = ".") {
  NoProgress silent;
  BlockSystem system = build_blocks(project, folder, silent);
  return {std::move(project), std::move(system)};
}

Entry crowd(CrowdKind kind, int n, Entry more = {}, BodyKind body = BodyKind::rigid, int seed = 1, int cells = 0) {
  const Crowd asked{kind, n, seed, body, 0.01, more.skip + more.steps, more.sleeps, cells};
  more.title = name_of(asked);
  if (body == BodyKind::rigid && seed == 1) more.kind = more.title.substr(0, more.title.find(' '));
  more.name = more.title;
  std::erase(more.name, ',');
  std::replace(more.name.begin(), more.name.end(), ' ', '_');
  more.build = [asked] { return scene_of(asked); };
  return more;
}

/// A block of 1 m that slides down a plane of 30°; its edge has so many cells of six tetrahedra.
CaseScene block_on_incline(BodyKind body, int cells) {
  CaseScene scene = rock_scene(20);
  scene.project.solver.sleep_tolerance = 0;
  tilt(scene, 30);
  scene.add_block("block", box_mesh(Vec3(0, 0, 0), Vec3(1, 1, 1), cells, cells, cells), body);
  scene.add_fixed_box("plane", Vec3(-2, -5, -1), Vec3(100, 5, 0));
  scene.project.stages = {dynamic_stage(1e-3, 1.1)};
  return scene;
}

Entry incline(const std::string& name, const std::string& title, BodyKind body, int cells) {
  return {.name = name,
          .title = title,
          .build = [body, cells] { return block_on_incline(body, cells); },
          .skip = 50,
          .steps = 1000,
          .beside_bullet = body == BodyKind::rigid};
}

CaseScene jiweishan() {
  const std::filesystem::path folder = std::filesystem::path(TALUS_SAMPLES) / "jiweishan";
  return built(read_project(folder / "jiweishan.talus"), folder);
}

std::vector<Entry> all_entries() {
  using enum CrowdKind;
  return {
      crowd(pile, 6),
      crowd(pile, 10),
      crowd(pile, 22, {.large = true}),
      crowd(pile, 3, {}, BodyKind::tetrahedra, 1, 4),
      crowd(pile, 5, {.large = true}, BodyKind::tetrahedra, 1, 4),
      crowd(pile, 8, {.large = true}, BodyKind::tetrahedra, 1, 4),
      crowd(slide, 5),
      crowd(slide, 10),
      crowd(slope, 6),
      crowd(slope, 6, {}, BodyKind::rigid, 2),
      crowd(slope, 6, {}, BodyKind::affine),
      crowd(slope, 6, {}, BodyKind::tetrahedra),
      crowd(slope, 12),
      crowd(slope, 18, {.large = true}),
      crowd(slope, 24, {.large = true}),
      crowd(slope, 30, {.large = true}),
      crowd(slope, 60, {.large = true}),
      crowd(stand, 12, {.skip = 60, .sleeps = true}),
      crowd(stand, 30, {.large = true, .skip = 60, .sleeps = true}),
      crowd(pour, 100, {.steps = 200}),
      crowd(pour, 500, {.large = true, .steps = 400}),
      incline("incline_rigid", "a rigid block on an incline", BodyKind::rigid, 1),
      incline("incline_48", "of 48 tetrahedra", BodyKind::tetrahedra, 2),
      incline("incline_384", "of 384 tetrahedra", BodyKind::tetrahedra, 4),
      {.name = "jiweishan", .title = "Jiweishan", .build = jiweishan, .steps = 1000, .beside_bullet = false},
  };
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What the steps that count came to.
struct Measured {
  int steps = 0;
  double processor = 0, wall = 0;  ///< s
  Phases phases;                   ///< s, wall
  long iterations = 0, cuts = 0, points = 0;
  int asleep = 0;
  double penetration = 0;  ///< deepest, of the mesh size
  std::string failure;

  double milliseconds() const { return 1e3 * processor / std::max(1, steps); }
};

void add(Measured& sum, const StepReport& step) {
  ++sum.steps;
  sum.iterations += step.iterations;
  sum.cuts += step.cuts;
  sum.asleep = step.asleep;
  sum.penetration = std::max(sum.penetration, step.max_relative_penetration);
  const auto add_phase = [&](double Phases::*phase) { sum.phases.*phase += step.phases.*phase; };
  for (double Phases::*phase : {&Phases::detect, &Phases::assemble, &Phases::factor, &Phases::solve, &Phases::update})
    add_phase(phase);
}

/// Steps until there are so many that count, or the processor's `seconds` are spent.
Measured measure(const Entry& entry, const CaseScene& scene, int threads, int steps, double seconds) {
  const ThreadLimit limit(threads);
  Simulation simulation(scene.project, scene.system);
  Measured measured;
  const double give_up = processor_seconds() + seconds;
  for (int skipped = 0; skipped < entry.skip && !simulation.finished(); ++skipped) {
    simulation.step();
    if (processor_seconds() > give_up) {
      measured.failure = "no " + std::to_string(entry.skip) + " steps within the time that it has";
      return measured;
    }
  }
  const long points = simulation.work().contact_points;
  const double processor = processor_seconds(), wall = wall_seconds();
  while (measured.steps < steps && !simulation.finished()) {
    add(measured, simulation.step());
    if (processor_seconds() > give_up) break;
  }
  measured.processor = processor_seconds() - processor;
  measured.wall = wall_seconds() - wall;
  measured.points = simulation.work().contact_points - points;
  if (!simulation.converged()) measured.failure = simulation.failure();
  return measured;
}

/// Milliseconds a step of Bullet; 0 where it is not there, or the scene is none for it.
double bullet_milliseconds([[maybe_unused]] const Entry& entry, [[maybe_unused]] const CaseScene& scene,
                           [[maybe_unused]] int steps) {
#if TALUS_HAS_BULLET
  if (!entry.beside_bullet) return 0;
  BulletWorld world(scene.project, scene.system, entry.sleeps);
  const double length = scene.project.stages.back().time_step;
  for (int i = 0; i < entry.skip; ++i) world.step(length);
  const double begin = processor_seconds();
  for (int i = 0; i < steps; ++i) world.step(length);
  return 1e3 * (processor_seconds() - begin) / std::max(1, steps);
#else
  return 0;
#endif
}

std::string or_dash(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return value > 0 ? text : "–";
}

void print_head() {
  std::printf(
      "| crowd | blocks | built, ms a block | steps | ms a step | µs a block | iterations | cuts | points | deepest, h "
      "| detection, assembly, linear, rest, %% | asleep | wall, 1 thread over 2 | Bullet, ms | × Bullet |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|--:|--:|--:|--:|\n");
}

void print_row(const Entry& entry, int blocks, double building, const Measured& one, const Measured& two,
               double bullet) {
  const double steps = std::max(1, one.steps);
  const Phases& p = one.phases;
  const double all = std::max(1e-12, p.detect + p.assemble + p.factor + p.solve + p.update);
  const double linear = p.factor + p.solve;
  std::printf(
      "| %s | %d | %.1f | %d | %.3g | %.3g | %.1f | %ld | %.0f | %.1e | %.0f, %.0f, %.0f, %.0f | %d | %s | %s | %s |\n",
      entry.title.c_str(), blocks, 1e3 * building / std::max(1, blocks), one.steps, one.milliseconds(),
      1e3 * one.milliseconds() / std::max(1, blocks), static_cast<double>(one.iterations) / steps, one.cuts,
      static_cast<double>(one.points) / steps, one.penetration, 100 * p.detect / all, 100 * p.assemble / all,
      100 * linear / all, 100 * p.update / all, one.asleep,
      or_dash("%.2f", two.wall > 0 ? one.wall / two.wall : 0).c_str(), or_dash("%.3g", bullet).c_str(),
      or_dash("%.3g", bullet > 0 ? one.milliseconds() / bullet : 0).c_str());
  if (!one.failure.empty()) std::printf("\n%s: %s\n\n", entry.title.c_str(), one.failure.c_str());
  std::fflush(stdout);
}

struct Asked {
  bool large = false;
  double seconds = 60;  ///< of the processor, a crowd and number of threads
  double tolerance = SolverSettings{}.tolerance;
  std::vector<std::string> names;
};

/// Number of blocks and milliseconds a step of what was measured of each kind.
using Growth = std::map<std::string, std::vector<std::pair<double, double>>>;

/// The exponent of growth by least squares of logarithms.
double exponent_of(const std::vector<std::pair<double, double>>& sizes) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [blocks, milliseconds] : sizes) {
    const double a = std::log(blocks), b = std::log(milliseconds);
    x += a, y += b, xx += a * a, xy += a * b;
  }
  const double n = static_cast<double>(sizes.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

void print_growth(const Growth& growth) {
  for (const auto& [kind, sizes] : growth) {
    if (sizes.size() < 2) continue;
    const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
    std::printf("\n%s: a step's time grows as the number of blocks to the power of %.2f, from %.0f to %.0f blocks\n",
                kind.c_str(), exponent_of(sizes), least->first, most->first);
  }
}

void measure(const Entry& entry, const Asked& asked, Growth& growth) try {
  const double begin = wall_seconds();
  CaseScene scene = entry.build();
  const double building = wall_seconds() - begin;
  scene.project.solver.tolerance = asked.tolerance;
  const auto blocks = std::count_if(scene.system.blocks.begin(), scene.system.blocks.end(),
                                    [](const Block& block) { return block.body != BodyKind::fixed; });
  const Measured one = measure(entry, scene, 1, entry.steps, asked.seconds);
  const Measured two = one.steps > 0 ? measure(entry, scene, 2, one.steps, 10 * asked.seconds) : Measured{};
  print_row(entry, static_cast<int>(blocks), building, one, two, bullet_milliseconds(entry, scene, entry.steps));
  if (!entry.kind.empty() && one.steps > 0)
    growth[entry.kind].emplace_back(static_cast<double>(blocks), one.milliseconds());
} catch (const std::exception& error) {
  std::printf("\n%s: %s\n\n", entry.title.c_str(), error.what());
}

int measure_all(const Asked& asked) {
  print_head();
  Growth growth;
  int measured = 0;
  for (const Entry& entry : all_entries()) {
    const bool named = std::find(asked.names.begin(), asked.names.end(), entry.name) != asked.names.end();
    if (!(asked.names.empty() ? asked.large || !entry.large : named)) continue;
    measure(entry, asked, growth);
    ++measured;
  }
  print_growth(growth);
  if (measured > 0) return 0;
  std::printf("no such crowd; there are:");
  for (const Entry& entry : all_entries()) std::printf(" %s", entry.name.c_str());
  std::printf("\n");
  return 2;
}

}  // namespace
}  // namespace talus

int main(int count, char** words) {
  talus::Asked asked;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const char* value = i + 1 < count ? words[i + 1] : "";
    if (word == "--large") {
      asked.large = true;
    } else if (word == "--seconds") {
      asked.seconds = std::atof(value);
      ++i;
    } else if (word == "--tolerance") {
      asked.tolerance = talus::tolerance_from(value).value_or(asked.tolerance);
      ++i;
    } else {
      asked.names.push_back(word);
    }
  }
  return talus::measure_all(asked);
}
