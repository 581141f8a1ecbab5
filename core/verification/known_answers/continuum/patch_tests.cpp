#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "bodies/strain.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/continuum/continuum_cases.hpp"
#include "verification/known_answers/support/scene.hpp"
#include "verification/known_answers/support/surface_loads.hpp"

namespace talus {

namespace {

const Material rock{.name = "rock", .density = 2600, .young = 10e9, .poisson = 0.25};

Mat3 tensor_of(const Voigt& s) {
  Mat3 t;
  t << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return t;
}

/// Static steps so long that inertia plays no part: each takes what is left of the imbalance.
Stage at_rest() { return static_stage(1, 4); }

/// Largest difference of a component of any tetrahedron's stress from the expected one, over the largest of those.
double stress_deviation(const CaseScene& scene, const Voigt& expected, Progress& progress) {
  double deviation = 0;
  run_scene(scene, progress, [&](const Simulation& simulation, const StepReport&) {
    deviation = 0;
    for (const Voigt& stress : simulation.frame(0).stress)
      deviation = std::max(deviation, (stress - expected).cwiseAbs().maxCoeff());
    return true;
  });
  return deviation / expected.cwiseAbs().maxCoeff();
}

/// A skew hexahedron whose inner nodes are moved by up to a fifth of a cell: no two tetrahedra are alike.
TetMesh distorted_mesh() {
  constexpr int cells = 3;
  const std::array<Vec3, 8> corners{{{0, 0, 0},
                                     {1, 0, 0.1},
                                     {-0.1, 1.1, 0},
                                     {1.1, 0.9, -0.1},
                                     {0, 0.1, 1},
                                     {0.9, 0, 1.2},
                                     {0.1, 1, 0.9},
                                     {1.2, 1.1, 1}}};
  TetMesh mesh = hexahedron_mesh(corners, cells, cells, cells);
  for (int k = 1; k < cells; ++k)
    for (int j = 1; j < cells; ++j)
      for (int i = 1; i < cells; ++i) {
        const int node = i + (cells + 1) * (j + (cells + 1) * k);
        mesh.nodes[node] += 0.2 / cells * Vec3(std::sin(5.0 * node), std::sin(7.0 * node), std::sin(11.0 * node));
      }
  return mesh;
}

/// Dead loads of a uniform stress P on the undeformed surface. P is symmetric, so nothing turns: F = I + ε(P), and the
/// stress per deformed area is P Fᵀ / det F. The held points are held where that takes them.
CaseOutcome one_block(const CaseOptions& options, Progress& progress) {
  Voigt nominal;
  nominal << -3e6, -2e6, -5e6, 1e6, 0.5e6, -1e6;
  const Mat3 piola = tensor_of(nominal);
  const Elastic elastic = Elastic::of(rock);
  const double trace = piola.trace() / (3 * elastic.lambda + 2 * elastic.mu);
  const Mat3 gradient = Mat3::Identity() + (piola - elastic.lambda * trace * Mat3::Identity()) / (2 * elastic.mu);
  const Mat3 cauchy = piola * gradient.transpose() / gradient.determinant();
  Voigt expected;
  expected << cauchy(0, 0), cauchy(1, 1), cauchy(2, 2), cauchy(0, 1), cauchy(1, 2), cauchy(2, 0);

  const auto deviation = [&](Strain strain) {
    CaseScene scene;
    scene.project.gravity.setZero();
    scene.project.solver.strain = strain;
    scene.project.solver.tolerance = reference_tolerance.value;  // stresses are exact but for rounding
    scene.add_material(rock);
    scene.add_block("block", distorted_mesh(), BodyKind::tetrahedra);
    const Block& block = scene.system.blocks.front();
    scene.project.loads = surface_loads(block, [&](const Vec3&, const Vec3& normal) { return Vec3(piola * normal); });
    scene.project.constraints = held_in_place("block", block.mesh.nodes[0], block.mesh.nodes[3], block.mesh.nodes[12]);
    for (Constraint& held : scene.project.constraints)
      for (int k = 0; k < 3; ++k)
        if (held.displacement[k]) held.displacement[k] = ((gradient - Mat3::Identity()) * *held.at)[k];
    scene.project.stages.push_back(at_rest());
    return stress_deviation(as_asked(scene, options), options.scale * expected, progress);
  };
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "deviation from uniform stress, corotational strain",
                              .unit = "",
                              .computed = deviation(Strain::corotational),
                              .tolerance = 1e-10,
                              .absolute = true});
  outcome.findings.push_back({.quantity = "the same, incremental strain",
                              .unit = "",
                              .computed = deviation(Strain::incremental),
                              .tolerance = 1e-10,
                              .absolute = true,
                              .reported = true});
  outcome.remarks.push_back(
      "Incremental strain is linear in the step: its stress differs from the exact one by the square of the strain.");
  return outcome;
}

/// Two cubes on each other, meshed so that no diagonal and no inner node of one meets the other's.
CaseScene two_cubes(double pressure) {
  CaseScene scene;
  scene.project.gravity.setZero();
  scene.add_material(rock);
  Joint joint;
  joint.name = "joint";
  joint.friction_angle = 30;
  scene.add_joint(joint);
  scene.add_block("lower", box_mesh({0, 0, 0}, {1, 1, 1}, 3, 3, 3), BodyKind::tetrahedra);
  scene.add_block("upper", box_mesh({0, 0, 1}, {1, 1, 2}, 4, 4, 4, true), BodyKind::tetrahedra);
  const auto press = [&](const Block& block, double side) {
    for (const PointLoad& load : surface_loads(block, [&](const Vec3&, const Vec3& normal) {
           return Vec3(0, 0, normal.z() * side > 0.5 ? -side * pressure : 0);
         }))
      scene.project.loads.push_back(load);
  };
  press(scene.system.blocks[0], -1);
  press(scene.system.blocks[1], 1);
  scene.project.constraints = held_in_place("lower", {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  scene.project.stages.push_back(at_rest());
  return scene;
}

CaseOutcome across_a_joint(const CaseOptions& options, Progress& progress) {
  constexpr double pressure = 1e6;
  const double widening = 1 + rock.poisson * pressure / rock.young;  // the load is dead, its area grows
  Voigt expected = Voigt::Zero();
  expected[2] = -pressure * options.scale / (widening * widening);
  CaseOutcome outcome;
  for (const ContactModel contact : {ContactModel::area, ContactModel::facet_wise}) {
    CaseScene scene = two_cubes(pressure);
    scene.project.solver.contact = contact;
    outcome.findings.push_back({.quantity = "deviation from uniform stress, contact " + std::string(to_string(contact)),
                                .unit = "",
                                .computed = stress_deviation(as_asked(scene, options), expected, progress),
                                .tolerance = 0.01,
                                .absolute = true,
                                .reported = contact == ContactModel::facet_wise});
  }
  return outcome;
}

}  // namespace

std::vector<KnownCase> patch_test_cases() {
  return {{.name = "patch_test",
           .title = "Uniform stress in distorted tetrahedra",
           .source = "Irons' patch test: linear displacements lie in the space of four-node tetrahedra",
           .run = one_block},
          {.name = "patch_test_joint",
           .title = "Uniform pressure across a joint of two meshes that do not match",
           .source = "equilibrium: the stress is the pressure everywhere",
           .run = across_a_joint}};
}

}  // namespace talus
