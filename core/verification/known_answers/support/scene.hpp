#pragma once

#include <functional>
#include <stdexcept>

#include "mesh/block.hpp"
#include "mesh/structured_mesh.hpp"
#include "solve/simulation.hpp"
#include "verification/known_answers/support/known_case.hpp"

namespace talus {

/// A scene built in the program: a project without shapes, and the blocks that would come of them.
struct CaseScene {
  Project project;
  BlockSystem system;

  /// Names in the order they were added; `material` and `joint` are made once and may be changed in `project` later.
  int add_material(const Material& material);
  int add_joint(const Joint& joint);
  /// A meshed block whose whole surface lies on no joint; contacts take `project.default_joint` or an interface's.
  void add_block(const std::string& name, TetMesh mesh, BodyKind body, int material = 0);
  /// A fixed box, and a deformable one of six tetrahedra.
  void add_fixed_box(const std::string& name, const Vec3& min, const Vec3& max);
  void add_box(const std::string& name, const Vec3& min, const Vec3& max);
  /// A fixed block that is only its surface: faces counter-clockwise seen from outside.
  void add_ground(const std::string& name, const std::vector<Vec3>& nodes,
                  const std::vector<std::array<int, 3>>& triangles, int material = 0);
  Monitor& add_monitor(const std::string& name, const std::string& block, const Vec3& at);
};

/// One rock (2600 kg/m³, 50 GPa, 0.24) and one joint of that friction angle [degrees]; no blocks, no stages.
CaseScene rock_scene(double friction_angle);

/// Makes gravity that of a plane which dips by `dip` degrees towards +x, in the plane's own axes: z is its normal.
void tilt(CaseScene& scene, double dip);

/// The scene at another scale that behaves alike (Froude's and Cauchy's similarity): lengths × s, times × √s,
/// velocities × √s, moduli, stresses and strengths × s, forces × s³, rates × 1/√s; densities, angles, gravity and joint
/// stiffnesses [Pa/m] stay. What the project expects of a run goes along.
CaseScene scaled(CaseScene scene, double s);

/// At the scale, with the bodies, by the scheme and to the tolerance that a case was asked to run with.
CaseScene as_asked(CaseScene scene, const CaseOptions& options);

/// The solver did not converge: where, and at which contact.
class NoAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs all stages; `after_step` may return false to end the run. Every case holds the energy ledger to close: throws
/// std::runtime_error where its remainder exceeds 1e-8 of the energy that moved, NoAnswer where the solver does not
/// converge, Cancelled when `progress` says so.
void run_scene(const CaseScene& scene, Progress& progress,
               const std::function<bool(const Simulation&, const StepReport&)>& after_step = {});

}  // namespace talus
