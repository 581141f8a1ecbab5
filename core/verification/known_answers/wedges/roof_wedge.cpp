#include <Eigen/Geometry>
#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/support/recorded_run.hpp"
#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {

namespace {

constexpr double wedge_height = 1;                                          // m
const double sine = std::sin(radians(60)), cosine = std::cos(radians(60));  // of the joints' dip
constexpr std::array<double, 3> dip_directions{30, 150, 270};               // degrees
constexpr double density = 2700, roof_gravity = 9.81;                       // kg/m³, m/s²
constexpr double normal_stiffness = 1e8;                                    // Pa/m
constexpr double roof_young = 1e11;  // Pa: stiff beside the joints, as the closed answer is that of a rigid wedge
constexpr double roof_time_step = 0.01, roof_fall_time = 0.2;  // s
constexpr int roof_static_steps = 40;
constexpr double roof_fallen = 0.02;           // m
constexpr double roof_angle_tolerance = 0.05;  // degrees

/// A wedge in a roof between three joints, its apex up, its base in the roof. The rock pressed against it with a
/// horizontal stress, the same all round, before the roof was laid bare.
struct RoofWedge {
  double stress = 0;           ///< Pa
  double stiffness_ratio = 1;  ///< shear over normal stiffness of the joints
};

/// Of the base's inner circle [m]. The base is an equilateral triangle, each face an isosceles one on a side of it.
double inner_radius() { return wedge_height * cosine / sine; }
double face_area() { return std::sqrt(3.0) * inner_radius() * wedge_height / sine; }
double weight() { return std::sqrt(3.0) * inner_radius() * inner_radius() * wedge_height * density * roof_gravity; }

/// Degrees. On each face the rock bears N and, up the dip δ, T; a horizontal stress p gives N₀ = p sin²δ A and
/// T₀ = p sin δ cos δ A, which balance without weight. Sinking by u under its weight, the wedge gains shear force
/// k_s A u sin δ and loses normal force k_n A u cos δ on each face until T sin δ − N cos δ = W/3. The faces must bear
/// T/N ≤ tan φ there: once they slip, what holds, N (tan φ sin δ − cos δ), falls with every further u. It is the
/// friction at which the support force of Goodman, Shi & Boyle (1982) vanishes; as p grows it falls to 90° − δ.
double critical_friction_angle(const RoofWedge& wedge) {
  const double shear_stiffness = wedge.stiffness_ratio * normal_stiffness;
  const double sinking =
      weight() / (3 * face_area() * (shear_stiffness * sine * sine + normal_stiffness * cosine * cosine));
  const double shear = wedge.stress * sine * cosine + shear_stiffness * sinking * sine;
  const double normal = wedge.stress * sine * sine - normal_stiffness * sinking * cosine;
  return degrees(std::atan2(shear, normal));
}

Vec3 horizontal(double direction) { return {std::sin(radians(direction)), std::cos(radians(direction)), 0}; }

/// Corner of the base between two faces [m].
Vec3 base_corner(double direction_1, double direction_2) {
  const Vec3 outward = horizontal(direction_1) + horizontal(direction_2);
  return outward * (inner_radius() / outward.dot(horizontal(direction_1)));
}

/// The rock beside a face of the wedge: the prism that the face sweeps when it goes outwards.
void add_rock(CaseScene& scene, const std::string& name, const std::array<Vec3, 3>& face, const Vec3& outward) {
  std::vector<Vec3> nodes(face.begin(), face.end());
  for (const Vec3& corner : face) nodes.push_back(corner + wedge_height * outward);
  scene.add_ground(name, nodes,
                   {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}});
}

/// Moves the rock so that a face bears the horizontal stress [m].
Constraint pressing(const std::string& rock, const RoofWedge& wedge, const Vec3& outward) {
  const Vec3 normal = sine * outward + cosine * Vec3::UnitZ(), up_dip = -cosine * outward + sine * Vec3::UnitZ();
  const Vec3 displacement =
      wedge.stress * sine / normal_stiffness * (-sine * normal + cosine / wedge.stiffness_ratio * up_dip);
  Constraint constraint;
  constraint.block = rock;
  for (int k = 0; k < 3; ++k) constraint.displacement[k] = displacement[k];
  return constraint;
}

CaseScene roof(const RoofWedge& wedge, double friction_angle) {
  CaseScene scene;
  scene.add_material({.name = "rock", .density = density, .young = roof_young, .poisson = 0.25});
  Joint joint;
  joint.name = "joint";
  joint.friction_angle = friction_angle;
  joint.normal_stiffness = normal_stiffness;
  joint.shear_stiffness = wedge.stiffness_ratio * normal_stiffness;
  scene.add_joint(joint);

  const Vec3 apex(0, 0, wedge_height);
  TetMesh mesh;
  for (int i = 0; i < 3; ++i) {
    const double direction = dip_directions[i];
    const Vec3 left = base_corner(dip_directions[(i + 2) % 3], direction);
    const Vec3 right = base_corner(direction, dip_directions[(i + 1) % 3]);
    const std::string name = "rock " + std::to_string(i + 1);
    add_rock(scene, name, {left, apex, right}, horizontal(direction));
    scene.project.constraints.push_back(pressing(name, wedge, horizontal(direction)));
    mesh.nodes.push_back(left);
  }
  mesh.nodes.push_back(apex);
  mesh.tetrahedra = {{0, 2, 1, 3}};
  scene.add_block("wedge", refined(mesh), BodyKind::tetrahedra);
  scene.project.stages = {static_stage(roof_time_step, roof_static_steps),
                          dynamic_stage(roof_time_step, roof_fall_time)};
  return scene;
}

/// The friction angle [degrees] between that of a wedge that falls and of one that stays.
double computed_friction_angle(const RoofWedge& wedge, const CaseOptions& options, Progress& progress) {
  double falls = 20, stays = 70;
  while (stays - falls > 0.1 * roof_angle_tolerance) {
    const double middle = (falls + stays) / 2;
    (sets_off(roof(wedge, middle), roof_fallen, options, progress) ? falls : stays) = middle;
  }
  return (falls + stays) / 2;
}

/// Of the wedge without stress [m/s²].
double acceleration_of_fall(const CaseOptions& options, Progress& progress) {
  const std::vector<Snapshot> snapshots = record(roof({}, 60), options, progress);
  const Snapshot &middle = snapshots[snapshots.size() - 11], &end = snapshots.back();
  return (end.blocks[3].velocity - middle.blocks[3].velocity).norm() / (end.time - middle.time);
}

}  // namespace

CaseOutcome roof_wedge_case(const CaseOptions& options, Progress& progress) {
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "acceleration without stress, φ 60°",
                              .unit = "m/s²",
                              .expected = roof_gravity,
                              .computed = acceleration_of_fall(options, progress),
                              .tolerance = 1e-6});
  for (const RoofWedge& wedge : {RoofWedge{50e3, 1}, RoofWedge{50e3, 0.25}, RoofWedge{20e3, 1}, RoofWedge{500e3, 1}})
    outcome.findings.push_back({.quantity = "critical friction angle, " + decimals(wedge.stress / 1e3, 0) +
                                            " kPa, k_s/k_n " + decimals(wedge.stiffness_ratio, 2),
                                .unit = "°",
                                .expected = critical_friction_angle(wedge),
                                .computed = computed_friction_angle(wedge, options, progress),
                                .tolerance = roof_angle_tolerance,
                                .absolute = true});
  return outcome;
}

}  // namespace talus
