#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"
#include "model/rock/blocks.hpp"
#include "model/rock/cut.hpp"
#include "model/rock/solid.hpp"
#include "model/solver_settings.hpp"

/// What the user described, as plain values in SI units. Angles are kept in degrees here, as the file has them,
/// so that a project is written back digit for digit; the solver converts once.
namespace talus {

/// How stress follows strain: in proportion, measured in the rotated frame; or by Simo's neo-Hookean energy, which no
/// stress squeezes to nothing.
enum class MaterialLaw { linear, neo_hookean };

/// The word the project file uses.
constexpr std::string_view to_string(MaterialLaw law) { return law == MaterialLaw::linear ? "linear" : "neo-hookean"; }

/// Of whole rock by Mohr and Coulomb. Results are measured against it; no run uses it.
struct RockStrength {
  double cohesion = 0;                       ///< Pa
  double friction_angle = 0;                 ///< degrees
  std::optional<double> tensile_strength{};  ///< Pa, where tension is cut off; that of the envelope's apex when absent
  bool operator==(const RockStrength&) const = default;
};

struct Material {
  std::string name;
  double density = 0;  ///< kg/m³
  double young = 0;    ///< Pa
  double poisson = 0;
  double damping = 0;  ///< 1/s, of the mass: a force density −damping·ρ·v
  MaterialLaw law = MaterialLaw::linear;
  std::optional<RockStrength> strength{};
  bool operator==(const Material&) const = default;
};

struct Joint {
  std::string name;
  double friction_angle = 0;                      ///< degrees
  double cohesion = 0;                            ///< Pa
  double tensile_strength = 0;                    ///< Pa
  std::optional<double> residual_friction_angle;  ///< degrees; friction_angle when absent
  std::optional<double> normal_stiffness;         ///< Pa/m; automatic when absent
  std::optional<double> shear_stiffness;          ///< Pa/m
  std::optional<double> restitution;  ///< speed of parting over speed of approach, 0 to 1; absent: as springs do
  bool operator==(const Joint&) const = default;
};

struct Interface {
  std::array<std::string, 2> between;  ///< block names
  std::string joint;
  bool operator==(const Interface&) const = default;
};

/// A vector by time: linear between rows, constant before the first and after the last.
struct TableRow {
  double time = 0;  ///< s
  Vec3 value = Vec3::Zero();
  bool operator==(const TableRow&) const = default;
};
using TimeTable = std::vector<TableRow>;

/// Holds a point of a block, or, without `at`, moves a fixed block as a whole (a shaking base).
struct Constraint {
  std::string block;
  std::optional<Vec3> at;
  std::array<std::optional<double>, 3> displacement{0, 0, 0};  ///< m, since the start; an empty component is free
  TimeTable
      table{};  ///< m; where given, its values stand for those of `displacement`, whose empty components stay free
  bool operator==(const Constraint&) const = default;
};

struct PointLoad {
  std::string block;
  Vec3 at = Vec3::Zero();
  Vec3 force = Vec3::Zero();  ///< N
  TimeTable table{};          ///< N; where given, it stands for `force`
  bool operator==(const PointLoad&) const = default;
};

/// Stress in the rock before the run, tension positive: stress + gradient · (z − level).
struct InSituStress {
  std::vector<std::string> blocks;  ///< names; all blocks when empty
  Voigt stress = Voigt::Zero();     ///< Pa: xx, yy, zz, xy, yz, zx
  Voigt gradient = Voigt::Zero();   ///< Pa/m
  double level = 0;                 ///< m
  bool operator==(const InSituStress&) const = default;
};

struct InitialVelocity {
  std::string block;
  Vec3 linear = Vec3::Zero();   ///< m/s
  Vec3 angular = Vec3::Zero();  ///< rad/s about the block's centroid
  bool operator==(const InitialVelocity&) const = default;
};

enum class StageKind { static_, dynamic };

/// The word the project file and the results use.
constexpr std::string_view to_string(StageKind kind) { return kind == StageKind::static_ ? "static" : "dynamic"; }

/// Properties of a joint from a stage on; what is absent stays as it was.
struct JointChange {
  std::string name;
  std::optional<double> friction_angle, residual_friction_angle;  ///< degrees
  std::optional<double> cohesion, tensile_strength;               ///< Pa
  bool operator==(const JointChange&) const = default;
};

/// A block that is held, or let go, from a stage on: `fixed`, or the kind that it was built as (`automatic` too, where
/// that was asked for).
struct BlockChange {
  std::string name;
  BodyKind body = BodyKind::fixed;
  bool operator==(const BlockChange&) const = default;
};

/// Changes hold from the beginning of the stage to the end of the run, or until a later stage changes them again.
struct Stage {
  std::string name;
  StageKind kind = StageKind::dynamic;
  double time_step = 0;                 ///< s; with adaptive steps the longest
  std::optional<int> steps;             ///< one of steps and duration is given
  std::optional<double> duration;       ///< s
  bool until_equilibrium = false;       ///< static stages: end as soon as nothing moves any more
  double equilibrium_tolerance = 1e-5;  ///< unbalanced force over the largest force at which a stage is in equilibrium
  std::optional<double> damping{};      ///< 1/s, of all masses
  std::vector<JointChange> joints{};
  std::optional<std::vector<PointLoad>> loads{};         ///< in place of those before
  std::optional<std::vector<Constraint>> constraints{};  ///< in place of those before
  std::vector<BlockChange> blocks{};
  bool operator==(const Stage&) const = default;
};

struct Monitor {
  std::string name, block;
  Vec3 at = Vec3::Zero();
  bool stress = false;  ///< record the stress at the point too
  bool operator==(const Monitor&) const = default;
};

/// A number the run must come to: quantity "P1.displacement.z" or "P1.stress.zz" at `time`.
/// The tolerance is relative to |value|, absolute where the value is zero.
struct Expectation {
  std::string quantity;
  double time = 0, value = 0, tolerance = 0;
  std::optional<double> since;  ///< s; the value is the change since then (creep after a static stage), else since 0
  std::string source;
  bool operator==(const Expectation&) const = default;
};

struct Output {
  double every = 0.1;  ///< s of model time between frames
  bool operator==(const Output&) const = default;
};

struct Project {
  std::string name;
  Vec3 gravity{0, 0, -9.81};
  Vec3 origin =
      Vec3::Zero();  ///< m: coordinates of files less this are the project's; sites are 10⁶ m from their grid's
  std::vector<Material> materials;
  std::vector<Joint> joints;
  std::string default_joint;
  std::vector<Solid> solids;
  std::vector<Cut> cuts;
  std::vector<BlockOverride> blocks;
  std::vector<Merge> merges;
  Splinters splinters;
  MeshSettings mesh;
  std::vector<Interface> interfaces;
  std::vector<Constraint> constraints;
  std::vector<PointLoad> loads;
  std::vector<InitialVelocity> velocities;
  std::vector<InSituStress> in_situ;
  std::vector<Stage> stages;
  SolverSettings solver;
  std::vector<Monitor> monitors;
  std::vector<Expectation> expect;
  Output output;
  bool operator==(const Project&) const = default;
};

}  // namespace talus
