#pragma once

#include "bodies/attachments.hpp"
#include "bodies/block_motion.hpp"
#include "effects/effect.hpp"

namespace talus {

/// A force on a point of a block.
struct LoadedPoint {
  MaterialPoint point;
  Vec3 force = Vec3::Zero();  ///< N, in the step that is tried
  TimeTable table = {};       ///< N; where not empty it gives the force
};

/// Work of forces on points, paper (25)(26):
///   Π = −Σ Fᵀ N_e(x) D_e  [J]
/// A force by table is that of the moment at which the time integration takes smooth forces.
class PointLoads final : public Effect {
 public:
  PointLoads(const BodySet& set, std::vector<LoadedPoint> loads) : loads_(std::move(loads)), moves_(set) {}
  EffectKind kind() const override { return EffectKind::point_load; }
  EnergyAccount account() const override { return EnergyAccount::potential; }
  void begin_step(const StepContext& step) override;
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;
  void add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const override;
  void accept(const Increment& d) override { potential_ += energy(d); }
  void archive(StateArchive& state) override { state(potential_); }
  double stored_energy() const override { return potential_; }  ///< minus the work done since the start

 private:
  std::vector<LoadedPoint> loads_;
  Attachments moves_;  ///< a load
  double potential_ = 0;
};

}  // namespace talus
