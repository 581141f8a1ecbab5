#pragma once

#include <optional>

#include "bodies/attachments.hpp"
#include "bodies/block_motion.hpp"
#include "effects/effect.hpp"

namespace talus {

/// A point of a block held at a displacement, component by component.
struct HeldPoint {
  MaterialPoint point;
  std::array<std::optional<double>, 3> displacement;  ///< m, since the start of the run; empty: free
  double stiffness = 0;                               ///< N/m
  TimeTable table = {};                               ///< m; where not empty it moves the components that are held
};

/// Very stiff springs that hold points where they are wanted, paper (22)–(24):
///   Π = ½ k Σ (u_c − u)²  [J]
/// with u_c what is still missing at the start of the step, so that a held point does not drift from step to step.
class DisplacementConstraints final : public Effect {
 public:
  DisplacementConstraints(const BodySet& set, std::vector<HeldPoint> points)
      : set_(set), points_(std::move(points)), moves_(set) {}
  EffectKind kind() const override { return EffectKind::displacement_constraint; }
  EnergyAccount account() const override { return EnergyAccount::constraint; }
  bool quadratic() const override { return !moves_.any_turns(); }
  bool constant() const override { return !moves_.any_turns(); }
  void begin_step(const StepContext& step) override;
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const override;
  void add_hessian(const Increment& d, SymmetricBlocks& sum) const override;
  void add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const override;

 private:
  /// u − u_c at the end of the step [m]; zero in free components.
  Vec3 excess(int point, const Increment& d) const;
  const BodySet& set_;
  std::vector<HeldPoint> points_;
  Attachments moves_;  ///< a point
};

}  // namespace talus
