#pragma once

#include "bodies/block_motion.hpp"
#include "effects/compose.hpp"
#include "results/run_report.hpp"

namespace talus {

/// What a contact point came to when a step was taken, for the ledger and for frames.
struct ContactForces {
  double normal = 0;          ///< N, compression positive
  Vec3 shear = Vec3::Zero();  ///< N, on the first body
  double gap = 0;             ///< m, at the end of the step
  double slip = 0;            ///< m, in this step
  ContactMode mode = ContactMode::open;
};

/// Keeps the energy ledger of a run [J]. What is missing from the energy it began with is the integration loss.
class EnergyBalance {
 public:
  EnergyBalance(const Project& project, const BlockSystem& system);

  /// Velocities were given from outside: their energy is new.
  void energy_was_given(double joules) { given_ += joules; }
  /// After the bodies have moved: adds the step's dissipation and takes stock.
  EnergyLedger after_step(const BodySet& set, const ContactSet& contacts, const std::vector<ContactForces>& forces);

 private:
  Vec3 gravity_;
  std::vector<std::pair<MaterialPoint, Vec3>> loads_;
  double given_ = 0, friction_ = 0;
};

}  // namespace talus
