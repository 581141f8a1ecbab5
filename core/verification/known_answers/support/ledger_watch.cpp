#include "verification/known_answers/support/ledger_watch.hpp"

#include "results/energy_moved.hpp"

namespace talus {

LedgerWatch::LedgerWatch(const CaseScene& scene) {
  double farthest = 0, weight = 0;
  for (const Block& block : scene.system.blocks) {
    for (const Vec3& node : block.mesh.nodes) farthest = std::max(farthest, node.cwiseAbs().maxCoeff());
    if (block.body != BodyKind::fixed)
      weight += block.volume * scene.project.materials[block.material].density * scene.project.gravity.norm();
  }
  rounding_ = weight * farthest * std::numeric_limits<double>::epsilon();
}

void LedgerWatch::look(const EnergyLedger& e) {
  moved_ = std::max(moved_, largest_account(e));
  const double dissipated = e.friction_dissipated + e.damping_dissipated + e.integration_loss - e.integration_reserve;
  growth_ = std::max(growth_, dissipated_ - dissipated);
  dissipated_ = std::max(dissipated_, dissipated);
  remainder_ = e.remainder;
  ++steps_;
}

}  // namespace talus
