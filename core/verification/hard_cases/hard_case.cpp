#include "verification/hard_cases/hard_case.hpp"

#include <algorithm>
#include <stdexcept>

namespace talus {

int Trajectory::block(const std::string& name) const {
  const auto found =
      std::find_if(system.blocks.begin(), system.blocks.end(), [&](const Block& one) { return one.name == name; });
  if (found == system.blocks.end()) throw std::logic_error("the scene has no block '" + name + "'");
  return static_cast<int>(found - system.blocks.begin());
}

const Snapshot& Trajectory::end_of_stage(int stage) const {
  const auto last = std::find_if(snapshots.rbegin(), snapshots.rend(),
                                 [stage](const Snapshot& snapshot) { return snapshot.stage == stage; });
  if (last == snapshots.rend()) throw std::logic_error("the run did not come to stage " + std::to_string(stage));
  return *last;
}

std::string_view to_string(FaultKind kind) {
  switch (kind) {
    case FaultKind::not_converged:
      return "not converged";
    case FaultKind::broken_off:
      return "broken off";
    case FaultKind::not_finite:
      return "not finite";
    case FaultKind::penetration:
      return "penetration";
    case FaultKind::interpenetration:
      return "interpenetration";
    case FaultKind::energy:
      return "energy";
    case FaultKind::ledger:
      return "ledger";
    case FaultKind::inverted:
      return "inverted";
    case FaultKind::lost:
      return "lost";
    case FaultKind::momentum:
      return "momentum";
    case FaultKind::expectation:
      return "expectation";
    case FaultKind::other_bits:
      return "other bits";
    case FaultKind::other_place:
      break;
  }
  return "other place";
}

std::vector<HardCase> with_perturbations(const HardCase& scene, int times) {
  std::vector<HardCase> scenes(times + 1, scene);
  for (int i = 1; i <= times; ++i) {
    scenes[i].name += "+" + std::to_string(i);
    scenes[i].build = [build = scene.build, factor = 1 + 1e-10 * i] {
      CaseScene perturbed = build();
      perturbed.project.gravity *= factor;
      for (InitialVelocity& velocity : perturbed.project.velocities) {
        velocity.linear *= factor;
        velocity.angular *= factor;
      }
      return perturbed;
    };
  }
  return scenes;
}

}  // namespace talus
