#pragma once

#include "bodies/block_motion.hpp"
#include "effects/effect.hpp"

namespace talus {

/// A force on a point of a block.
struct LoadedPoint {
  MaterialPoint point;
  Vec3 force;  ///< N
};

/// Work of forces on points, paper (25)(26):
///   Π = −Σ Fᵀ N_e(x) D_e  [J]
class PointLoads final : public Effect {
 public:
  PointLoads(const BodySet& set, std::vector<LoadedPoint> loads) : set_(set), loads_(std::move(loads)) {}
  std::string_view name() const override { return "point load"; }
  double energy(const Increment& d) const override;
  void add_gradient(const Increment& d, Eigen::VectorXd& sum) const override;

 private:
  const BodySet& set_;
  std::vector<LoadedPoint> loads_;
};

}  // namespace talus
