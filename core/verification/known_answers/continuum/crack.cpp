#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/continuum/continuum_cases.hpp"
#include "verification/known_answers/continuum/slipping_joint.hpp"
#include "verification/known_answers/support/convergence.hpp"
#include "verification/known_answers/support/scene.hpp"

namespace talus {

namespace {

const SlippingJoint plate{
    .height = 2, .width = 1, .young = 88.9e9, .stiffness = 220e9, .friction_angle = 16, .slipping_length = 0.54};
/// A slab thin enough for plane stress, two cells of it; stiffnesses are told for a thickness of 1 m.
constexpr double slab_thickness = 0.1;
constexpr double full_load = 1e-4;  ///< m, by which the top goes down

/// The joint rises at 45° from (0, 0.5) to (1, 1.5) through the plate's middle; its middle slips. `cells` is how many
/// cells of the mesh slip along it.
struct CrackMesh {
  int slipping_cells;
  double slipping_cell;  ///< m along x
  int beside;            ///< cells on either side

  /// Contact belongs to nodes. The ends of the slipping cells lie against wider ones and go with these: n + 1 cells
  /// slip as if they were n.
  explicit CrackMesh(int cells)
      : slipping_cells(cells + 1), slipping_cell(plate.slipping_length * std::cos(radians(45)) / cells) {
    beside = std::max(2, static_cast<int>(half_rest() / (1.2 * slipping_cell)));
  }
  double half_rest() const { return 0.5 - slipping_cells * slipping_cell / 2; }
  int cells() const { return slipping_cells + 2 * beside; }
  /// x of a line of nodes, numbered from 0 to cells().
  double line(int i) const {
    const double rest = half_rest();
    if (i <= beside) return rest * i / beside;
    if (i <= beside + slipping_cells) return rest + slipping_cell * (i - beside);
    return 1 - rest * (cells() - i) / beside;
  }
  bool slips(double x) const { return std::abs(x - 0.5) < slipping_cells * slipping_cell / 2; }
};

/// The plate below or above the joint.
TetMesh half_plate(const CrackMesh& crack, bool upper) {
  const int n = crack.cells();
  TetMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1}, n, 2, n);
  for (Vec3& node : mesh.nodes) {
    const double x = crack.line(static_cast<int>(std::lround(node.x() * n))), joint = 0.5 + x;
    node = Vec3(x, slab_thickness * node.y(), upper ? joint + node.z() * (plate.height - joint) : node.z() * joint);
  }
  return mesh;
}

void name_joints(Block& block, const CrackMesh& crack, int slipping, int bonded) {
  for (SurfaceTriangle& triangle : block.surface) {
    Vec3 centre = Vec3::Zero();
    bool on_joint = true;
    for (const int node : triangle.nodes) {
      const Vec3& place = block.mesh.nodes[node];
      centre += place / 3;
      on_joint = on_joint && std::abs(place.z() - place.x() - 0.5) < 1e-9;
    }
    if (on_joint) triangle.joint = crack.slips(centre.x()) ? slipping : bonded;
  }
}

/// The bottom is held, the top is lowered and raised again; both slide sideways.
void press(CaseScene& scene, double relief) {
  const TimeTable displacement{{0, Vec3::Zero()},
                               {4, {0, 0, -full_load}},
                               {8, {0, 0, -full_load * (1 - relief)}},
                               {24, {0, 0, -full_load * 0.1}}};
  for (const Block& block : scene.system.blocks)
    for (const Vec3& node : block.mesh.nodes) {
      Constraint held{.block = block.name, .at = node, .displacement = {std::nullopt, std::nullopt, 0}, .table = {}};
      if (node.z() == plate.height) held.table = displacement;
      if (node.z() == 0 && node.x() == 0.5) held.displacement[0] = 0;
      if (node.z() == 0 && node.y() == slab_thickness / 2) held.displacement[1] = 0;
      if (node.z() == 0 || node.z() == plate.height) scene.project.constraints.push_back(held);
    }
}

CaseScene cracked_plate(int cells) {
  CaseScene scene;
  scene.project.gravity.setZero();
  scene.add_material({.name = "rock", .density = 2700, .young = plate.young, .poisson = 0.26});
  Joint joint;
  joint.name = "crack";
  joint.friction_angle = plate.friction_angle;
  joint.normal_stiffness = joint.shear_stiffness = plate.stiffness;
  const int slipping = scene.add_joint(joint);
  joint.name = "bonded";
  joint.cohesion = joint.tensile_strength = 1e9;
  const int bonded = scene.add_joint(joint);
  const CrackMesh crack(cells);
  scene.add_block("lower", half_plate(crack, false), BodyKind::tetrahedra);
  scene.add_block("upper", half_plate(crack, true), BodyKind::tetrahedra);
  for (Block& block : scene.system.blocks) name_joints(block, crack, slipping, bonded);
  press(scene, 0.2);
  scene.project.stages.push_back(static_stage(1, 24));
  return scene;
}

/// Force on the top for 1 m of thickness [N]. A displacement that grows with z crosses the joint without a jump, so
/// that its virtual work says: the volume integral of σzz is the force times the height.
double top_force(const Simulation& simulation) {
  const std::vector<Voigt> stress = simulation.frame(0).stress;
  double sum = 0;
  for (std::size_t e = 0; e < stress.size(); ++e) sum -= simulation.bodies().shapes[e].volume * stress[e][2];
  return sum;
}

struct LoadCycle {
  std::vector<double> force;  ///< N for 1 m of thickness, by time step
  double slipping_length = 0;

  /// Stiffness between the two times at which the top had moved by these fractions of the full load [N/m].
  double stiffness(int from, int to, double share) const { return (force[to] - force[from]) / (share * full_load); }
};

LoadCycle load_and_unload(int cells, const CaseOptions& options, Progress& progress) {
  LoadCycle cycle;
  cycle.force.push_back(0);
  run_scene(as_asked(cracked_plate(cells), options), progress, [&](const Simulation& simulation, const StepReport&) {
    cycle.force.push_back(top_force(simulation) / std::pow(options.scale, 4) / plate.height / slab_thickness);
    cycle.slipping_length = 0;
    for (const ContactSample& contact : simulation.contacts())
      if (contact.joint == 0) cycle.slipping_length += contact.area / (options.scale * options.scale) / slab_thickness;
    return true;
  });
  return cycle;
}

CaseOutcome slipping_crack(const CaseOptions& options, Progress& progress) {
  CaseOutcome outcome;
  CaseTable table{"Stiffness of a plate with a slipping crack [GN/m]",
                  {"slipping cells", "loading", "first unloading", "last unloading"},
                  {}};
  LoadCycle cycle;
  const auto slopes = [&] {
    return std::array{cycle.stiffness(0, 4, 1), cycle.stiffness(5, 4, 0.05), cycle.stiffness(24, 20, 0.175)};
  };
  for (const int cells : options.thorough ? std::vector{4, 8, 16} : std::vector{4, 8}) {
    cycle = load_and_unload(cells, options, progress);
    const auto found = slopes();
    table.rows.push_back({std::to_string(cells), short_number(found[0] / 1e9), short_number(found[1] / 1e9),
                          short_number(found[2] / 1e9)});
  }
  const auto found = slopes();
  const std::array expected{plate.loading(), plate.first_unloading(), plate.last_unloading()};
  const std::array names{"loading", "first unloading", "last unloading"};
  for (std::size_t i = 0; i < found.size(); ++i)
    outcome.findings.push_back({.quantity = std::string("stiffness, ") + names[i],
                                .unit = "N/m",
                                .expected = expected[i],
                                .computed = found[i],
                                .tolerance = 0.02});
  outcome.findings.push_back({.quantity = "length that slips",
                              .unit = "m",
                              .expected = plate.slipping_length,
                              .computed = cycle.slipping_length,
                              .tolerance = 1e-3});
  outcome.tables.push_back(table);
  outcome.remarks.push_back(
      "The published slopes are those of springs, the plate is a continuum: they need not agree better than by what "
      "its slip is unlike theirs. Without slip both are exact.");
  return outcome;
}

}  // namespace

std::vector<KnownCase> crack_cases() {
  return {{.name = "slipping_crack",
           .title = "A plate with a slipping crack under load and unload",
           .source = "Olsson 1982; Brady et al. 1985: springs of rock and joint, slider beside a spring",
           .thinned = true,
           .run = slipping_crack}};
}

}  // namespace talus
