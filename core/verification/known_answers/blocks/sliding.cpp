#include "verification/known_answers/blocks/block_cases.hpp"

#include <cmath>

#include "base/units.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

namespace talus {

namespace {

constexpr int slab = 0, block = 1;

/// A block of 1 m on a long slab that dips towards +x, both in the slab's axes; the slab's mesh does not match.
CaseScene block_on_incline(double dip, double friction_angle) {
  CaseScene scene = rock_scene(friction_angle);
  tilt(scene, dip);
  scene.add_fixed_box("slab", Vec3(-4, -3, -1), Vec3(40, 3, 0));
  scene.add_box("block", Vec3(0, -0.5, 0), Vec3(1, 0.5, 1));
  return scene;
}

/// g (sin α − tan φ cos α) [m/s²].
double coulomb_acceleration(double g, double dip, double friction_angle) {
  return g * (std::sin(radians(dip)) - std::tan(radians(friction_angle)) * std::cos(radians(dip)));
}

double mean_acceleration(const std::vector<Snapshot>& snapshots, double from, double to) {
  double start = NAN, end = NAN, first = NAN, last = NAN;
  for (const Snapshot& snapshot : snapshots) {
    if (snapshot.time < from - 1e-9 || snapshot.time > to + 1e-9) continue;
    if (std::isnan(first)) first = snapshot.time, start = snapshot.blocks[block].velocity.x();
    last = snapshot.time, end = snapshot.blocks[block].velocity.x();
  }
  return (end - start) / (last - first);
}

CaseOutcome slides(const CaseOptions& options, Progress& progress) {
  struct Row {
    std::string name;
    double dip, friction_angle, g, density;
  };
  CaseOutcome outcome;
  for (const Row& row :
       {Row{"acceleration, 30°, φ 15°", 30, 15, 9.81, 2600}, Row{"acceleration, 28°, φ 22.5°", 28, 22.5, 9.81, 2600},
        Row{"acceleration, 40°, φ 20°, g 10 (3DEC)", 40, 20, 10, 2000}}) {
    CaseScene scene = block_on_incline(row.dip, row.friction_angle);
    scene.project.gravity *= row.g / scene.project.gravity.norm();
    scene.project.materials[0].density = row.density;
    scene.project.stages = {static_stage(0.01, 20), dynamic_stage(0.01, 1)};
    const auto snapshots = record(scene, options, progress);
    outcome.findings.push_back({.quantity = row.name,
                                .unit = "m/s²",
                                .expected = coulomb_acceleration(row.g, row.dip, row.friction_angle),
                                .computed = mean_acceleration(snapshots, 0.4, 1.2),
                                .tolerance = 1e-3});
  }
  return outcome;
}

/// What else is in the scene of a sticking block.
struct Company {
  std::string name;
  int others = 0;       ///< blocks that stick as well, in rows beside it
  bool moving = false;  ///< one slides down and off the slab, one falls onto it
};

CaseScene block_in_company(const Company& company) {
  CaseScene scene = block_on_incline(30, 35);
  for (int i = 0; i < company.others; ++i) {
    const Vec3 corner(1.7 * (1 + i % 10), i < 10 ? -2.5 : 0.7, 0);
    scene.add_box("other " + std::to_string(i + 1), corner, corner + Vec3(1, 1.2, 0.8));
  }
  if (!company.moving) return scene;
  Joint slick;
  slick.name = "slick";
  slick.friction_angle = 10;
  scene.add_joint(slick);
  scene.add_box("slider", Vec3(30, -0.5, 0), Vec3(31, 0.5, 1));
  scene.add_box("faller", Vec3(3, -0.4, 1.5), Vec3(4, 0.6, 2.5));
  scene.project.interfaces = {{{"slab", "slider"}, "slick"}};
  return scene;
}

CaseOutcome sticks(const CaseOptions& options, Progress& progress) {
  CaseOutcome outcome;
  for (const Company& company : {Company{"alone"}, Company{"5 others", 5}, Company{"20 others", 20},
                                 Company{"one slides, one falls", 0, true}}) {
    CaseScene scene = block_in_company(company);
    scene.project.solver.sleep_tolerance = 0;  // friction is to hold the blocks, not sleep
    scene.project.stages = {static_stage(0.01, 50), dynamic_stage(0.01, 10)};
    const auto snapshots = record(scene, options, progress);
    const Vec3 crept = snapshots.back().blocks[block].displacement - snapshots[50].blocks[block].displacement;
    outcome.findings.push_back({.quantity = "creep in 10 s of the size, " + company.name,
                                .unit = "",
                                .computed = crept.norm(),
                                .tolerance = 1e-9,
                                .absolute = true});
  }
  return outcome;
}

CaseOutcome stops(const CaseOptions& options, Progress& progress) {
  const double speed = 5, friction = 0.5, g = 9.81;
  CaseScene scene = block_on_incline(0, degrees(std::atan(friction)));
  InitialVelocity start;
  start.block = "block";
  start.linear = Vec3(speed, 0, 0);
  scene.project.velocities = {start};
  const double distance = speed * speed / (2 * friction * g);
  scene.project.stages = {static_stage(0.005, 20), dynamic_stage(0.002, 11.5)};
  const auto snapshots = record(scene, options, progress);
  const std::size_t at_rest = snapshots.size() - 5001;  // 10 s before the end; it stands after 1.02 s
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "distance to standstill",
                              .unit = "m",
                              .expected = distance,
                              .computed = snapshots.back().blocks[block].displacement.x(),
                              .tolerance = 1e-3});
  const Vec3 crept = snapshots.back().blocks[block].displacement - snapshots[at_rest].blocks[block].displacement;
  outcome.findings.push_back({.quantity = "creep in the 10 s after it, of the size",
                              .unit = "",
                              .computed = crept.norm(),
                              .tolerance = 1e-9,
                              .absolute = true});
  return outcome;
}

}  // namespace

std::vector<KnownCase> sliding_cases() {
  return {{.name = "block_slides",
           .title = "A block slides down an incline",
           .source = "a = g (sin α − tan φ cos α); 3DEC verification problem 'Sliding block'",
           .of_any_body = true,
           .run = slides},
          {.name = "block_sticks",
           .title = "A block below its friction angle stays, alone and in company",
           .source = "Coulomb: α < φ",
           .of_any_body = true,
           .run = sticks},
          {.name = "block_stops",
           .title = "A block at 5 m/s stops on a plane, μ = 0.5",
           .source = "v²/(2 μ g)",
           .of_any_body = true,
           .run = stops}};
}

}  // namespace talus
