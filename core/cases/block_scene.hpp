#pragma once

#include "bodies/block_motion.hpp"
#include "cases/scene.hpp"

/// What the cases of blocks share: rock, ground, stages, and where the blocks were when.
namespace talus {

/// One rock (2600 kg/m³, 50 GPa, 0.24) and one joint of that friction angle [degrees]; no blocks, no stages.
CaseScene rock_scene(double friction_angle);

/// Makes gravity that of a plane which dips by `dip` degrees towards +x, in the plane's own axes: z is its normal.
void tilt(CaseScene& scene, double dip);

/// A fixed box, and a deformable one of six tetrahedra.
void add_fixed_box(CaseScene& scene, const std::string& name, const Vec3& min, const Vec3& max);
void add_box(CaseScene& scene, const std::string& name, const Vec3& min, const Vec3& max);

/// A static stage in which blocks press themselves onto each other, and a dynamic one [s].
Stage settling(double time_step, int steps);
Stage motion(double time_step, double duration);

/// All blocks at the end of a step.
struct Moment {
  double time = 0;  ///< s
  int stage = 0;
  std::vector<BlockMotion> blocks;
};

/// Runs the scene at the scale asked for and says what happened as it would have been at full size: lengths ÷ s, times
/// and velocities ÷ √s. `go_on` may end the run early; it is asked after every step.
std::vector<Moment> record(const CaseScene& scene, const CaseOptions& options, Progress& progress,
                           const std::function<bool(const Moment&)>& go_on = {});

/// How far the block has gone that went farthest from one moment to another [m].
double farthest(const Moment& from, const Moment& to);

/// Whether any block goes farther than `distance` [m, at full size] after the settling stage; ends the run when one
/// does.
bool sets_off(const CaseScene& scene, double distance, const CaseOptions& options, Progress& progress);

/// A parameter between one at which a scene falls and one at which it stands.
struct Bracket {
  double falls = 0, stands = 0;
  double middle() const { return (falls + stands) / 2; }
};

/// Halves the bracket `runs` times; `falls_at` says what a run at a parameter does.
Bracket narrowed(Bracket bracket, int runs, const std::function<bool(double)>& falls_at);

/// A case that speaks of full size, made to say what was computed at its scale: findings in m are multiplied by s,
/// those in s and m/s by √s.
KnownCase at_any_scale(KnownCase full_size);

}  // namespace talus
