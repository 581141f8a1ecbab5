#include "verification/known_answers/support/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"
#include "base/units.hpp"
#include "model/quantity.hpp"
#include "verification/known_answers/support/ledger_watch.hpp"

namespace talus {

int CaseScene::add_material(const Material& material) {
  project.materials.push_back(material);
  return static_cast<int>(project.materials.size()) - 1;
}

int CaseScene::add_joint(const Joint& joint) {
  if (project.joints.empty()) project.default_joint = joint.name;
  project.joints.push_back(joint);
  system.joint_names.push_back(joint.name);
  return static_cast<int>(project.joints.size()) - 1;
}

void CaseScene::add_block(const std::string& name, TetMesh mesh, BodyKind body, int material) {
  Block block;
  block.name = name;
  block.solid = 0;
  block.material = material;
  block.body = body;
  block.surface = boundary(mesh);
  block.volume = volume(mesh);
  block.mesh = std::move(mesh);
  system.solids_volume += block.volume;
  system.blocks.push_back(std::move(block));
}

void CaseScene::add_fixed_box(const std::string& name, const Vec3& min, const Vec3& max) {
  add_block(name, box_mesh(min, max, 1, 1, 1), BodyKind::fixed);
}

void CaseScene::add_box(const std::string& name, const Vec3& min, const Vec3& max) {
  add_block(name, box_mesh(min, max, 1, 1, 1), BodyKind::tetrahedra);
}

void CaseScene::add_ground(const std::string& name, const std::vector<Vec3>& nodes,
                           const std::vector<std::array<int, 3>>& triangles, int material) {
  Block block;
  block.name = name;
  block.solid = 0;
  block.material = material;
  block.body = BodyKind::fixed;
  block.mesh.nodes = nodes;
  for (const auto& triangle : triangles) block.surface.push_back({triangle, -1});
  system.blocks.push_back(std::move(block));
}

Monitor& CaseScene::add_monitor(const std::string& name, const std::string& block, const Vec3& at) {
  return project.monitors.emplace_back(Monitor{name, block, at});
}

CaseScene rock_scene(double friction_angle) {
  CaseScene scene;
  scene.project.name = "blocks";
  Material rock;
  rock.name = "rock";
  rock.density = 2600;
  rock.young = 50e9;
  rock.poisson = 0.24;
  scene.add_material(rock);
  Joint joint;
  joint.name = "joint";
  joint.friction_angle = friction_angle;
  scene.add_joint(joint);
  return scene;
}

void tilt(CaseScene& scene, double dip) {
  const double g = scene.project.gravity.norm();
  scene.project.gravity = g * Vec3(std::sin(radians(dip)), 0, -std::cos(radians(dip)));
}

namespace {

void scale_loads(std::vector<PointLoad>& loads, double s) {
  for (PointLoad& load : loads) {
    load.at *= s;
    load.force *= s * s * s;
    for (TableRow& row : load.table) row.time *= std::sqrt(s), row.value *= s * s * s;
  }
}

void scale_constraints(std::vector<Constraint>& constraints, double s) {
  for (Constraint& constraint : constraints) {
    if (constraint.at) *constraint.at *= s;
    for (auto& component : constraint.displacement)
      if (component) *component *= s;
    for (TableRow& row : constraint.table) row.time *= std::sqrt(s), row.value *= s;
  }
}

void scale_expectation(Expectation& expectation, double s) {
  const double time = std::sqrt(s);
  expectation.time *= time;
  if (expectation.since) *expectation.since *= time;
  const auto quantity = parse_quantity(expectation.quantity);
  const double unit = similar(quantity ? quantity->field : Quantity::Field::displacement, s);
  if (expectation.value == 0) expectation.tolerance *= unit;  // absolute there
  expectation.value *= unit;
}

void scale_stage(Stage& stage, double s) {
  const double time = std::sqrt(s);
  stage.time_step *= time;
  if (stage.duration) *stage.duration *= time;
  if (stage.damping) *stage.damping /= time;
  for (JointChange& joint : stage.joints) {
    if (joint.cohesion) *joint.cohesion *= s;
    if (joint.tensile_strength) *joint.tensile_strength *= s;
  }
  if (stage.loads) scale_loads(*stage.loads, s);
  if (stage.constraints) scale_constraints(*stage.constraints, s);
}

}  // namespace

CaseScene scaled(CaseScene scene, double s) {
  Project& p = scene.project;
  for (Material& material : p.materials) material.young *= s, material.damping /= std::sqrt(s);
  for (Joint& joint : p.joints) joint.cohesion *= s, joint.tensile_strength *= s;
  scale_constraints(p.constraints, s);
  scale_loads(p.loads, s);
  for (InitialVelocity& velocity : p.velocities) velocity.linear *= std::sqrt(s), velocity.angular /= std::sqrt(s);
  for (InSituStress& stress : p.in_situ) stress.stress *= s, stress.level *= s;  // Pa/m stays
  for (Stage& stage : p.stages) scale_stage(stage, s);
  for (Monitor& monitor : p.monitors) monitor.at *= s;
  for (Expectation& expectation : p.expect) scale_expectation(expectation, s);
  p.output.every *= std::sqrt(s);
  for (Block& block : scene.system.blocks) {
    for (Vec3& node : block.mesh.nodes) node *= s;
    block.volume *= s * s * s;
  }
  scene.system.solids_volume *= s * s * s;
  return scene;
}

CaseScene as_asked(CaseScene scene, const CaseOptions& options) {
  for (Block& block : scene.system.blocks)
    if (block.body == BodyKind::tetrahedra) block.body = options.body;
  if (options.preset) adopt(*options.preset, scene.project.solver);
  double& tolerance = scene.project.solver.tolerance;
  if (tolerance == SolverSettings{}.tolerance) tolerance = options.tolerance.value_or(tolerance);
  return scaled(std::move(scene), options.scale);
}

namespace {

void require_closed(const LedgerWatch& ledger) {
  if (ledger.closes()) return;
  char text[120];
  std::snprintf(text, sizeof text, "the energy ledger does not close: %.3g J of %.3g J are missing", ledger.remainder(),
                ledger.moved());
  throw std::runtime_error(text);
}

}  // namespace

void run_scene(const CaseScene& scene, Progress& progress,
               const std::function<bool(const Simulation&, const StepReport&)>& after_step) {
  Simulation simulation(scene.project, scene.system);
  LedgerWatch ledger(scene);
  while (!simulation.finished()) {
    if (progress.cancelled()) throw Cancelled{};
    const StepReport report = simulation.step();
    if (!simulation.converged()) throw NoAnswer(simulation.failure());
    ledger.look(report.energy);
    if (after_step && !after_step(simulation, report)) break;
  }
  require_closed(ledger);
}

}  // namespace talus
