#include <Eigen/Geometry>
#include <cmath>

#include "base/units.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/support/recorded_run.hpp"
#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {

namespace {

constexpr double length = 1;                                        // m
constexpr double critical_time_step = 2e-3, critical_duration = 1;  // s
constexpr int critical_static_steps = 20;
constexpr double critical_angle_tolerance = 0.05;  // degrees
/// A wedge whose resisting forces fall short of the driving ones by this share slides.
constexpr double least_shortfall = 1e-4;

/// Upward normal of a plane [degrees].
Vec3 upward_normal(double dip, double dip_direction) {
  const double a = radians(dip), b = radians(dip_direction);
  return {std::sin(a) * std::sin(b), std::sin(a) * std::cos(b), std::cos(a)};
}

/// The planes 40°/130° and 60°/220°: the wedge and how it is turned into their frame, x east, z up.
struct CriticalWedge {
  CriticalWedge() {
    const Vec3 normal_1 = upward_normal(40, 130), normal_2 = upward_normal(60, 220);
    const Vec3 line = normal_1.cross(normal_2);
    turn = Eigen::AngleAxisd(std::atan2(line.y(), line.x()), Vec3::UnitZ()).toRotationMatrix();
    shape = wedge_between(turn.transpose() * normal_1, turn.transpose() * normal_2, length);
    equilibrium = wedge_equilibrium(turned(shape.planes(), turn), -Vec3::UnitZ());
  }

  CaseScene scene(double friction_angle) const {
    const Material rock{.name = "rock", .density = 2000, .young = 1e9, .poisson = 0.25};
    Joint planes;
    planes.name = "planes";
    planes.friction_angle = friction_angle;
    CaseScene scene = wedge_in_mould(shape, turn, rock, planes, 1);
    scene.project.stages = {static_stage(critical_time_step, critical_static_steps),
                            dynamic_stage(critical_time_step, critical_duration)};
    return scene;
  }

  Mat3 turn;
  WedgeShape shape;
  WedgeEquilibrium equilibrium;
};

/// The friction angle [degrees] between those of a wedge that slides and one that stays, to a twentieth of what it is
/// held to.
double critical_friction_angle(const CriticalWedge& wedge, const CaseOptions& options, Progress& progress) {
  double slides = 28, stays = 38;
  const double displacement =
      least_shortfall * 0.5 * 9.81 * wedge.equilibrium.driving * critical_duration * critical_duration;
  while (stays - slides > 0.05 * critical_angle_tolerance) {
    const double middle = (slides + stays) / 2;
    (sets_off(wedge.scene(middle), displacement, options, progress) ? slides : stays) = middle;
  }
  return (slides + stays) / 2;
}

/// Degrees below the horizontal in which the wedge goes at half the critical friction.
double plunge_of_motion(const CriticalWedge& wedge, const CaseOptions& options, Progress& progress) {
  const auto snapshots = record(wedge.scene(20), options, progress, [](const Snapshot& snapshot) {
    return snapshot.blocks[1].displacement.norm() < 0.1 * length;
  });
  const Vec3 displacement =
      snapshots.back().blocks[1].displacement - snapshots[snapshots.size() / 2].blocks[1].displacement;
  return degrees(std::asin(-displacement.z() / displacement.norm()));
}

}  // namespace

CaseOutcome critical_wedge_case(const CaseOptions& options, Progress& progress) {
  const CriticalWedge wedge;
  CaseOutcome outcome;
  outcome.findings = {{.quantity = "plunge of the motion",
                       .unit = "°",
                       .expected = degrees(std::asin(wedge.equilibrium.driving)),
                       .computed = plunge_of_motion(wedge, options, progress),
                       .tolerance = critical_angle_tolerance,
                       .absolute = true},
                      {.quantity = "critical friction angle",
                       .unit = "°",
                       .expected = wedge.equilibrium.critical_friction_angle(),
                       .computed = critical_friction_angle(wedge, options, progress),
                       .tolerance = critical_angle_tolerance,
                       .absolute = true}};
  return outcome;
}

}  // namespace talus
