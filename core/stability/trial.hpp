#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "bodies/body_set.hpp"
#include "stability/stability_scene.hpp"

/// Runs a scene of the stability suite and measures what no scene may break (docs/stability.md).
namespace talus {

/// How a run ended. What was thrown (bad input, a matrix that is not positive definite) broke it off.
enum class TrialEnding { completed, not_converged, broken_off };

/// The word that JSON uses.
constexpr std::string_view to_string(TrialEnding ending) {
  switch (ending) {
    case TrialEnding::completed:
      return "completed";
    case TrialEnding::not_converged:
      return "not-converged";
    case TrialEnding::broken_off:
      break;
  }
  return "broken-off";
}

/// What a sampled moment must have in common with that of another run: all bits of all positions, and iterations.
struct MomentPrint {
  double time = 0;              ///< s
  long iterations = 0;          ///< so far
  std::uint64_t positions = 0;  ///< hash over all nodes
  bool operator==(const MomentPrint&) const = default;
};

/// What came of running a scene once more.
struct TrialRepetition {
  int threads = 1;
  std::string difference;  ///< where the runs part; empty: the same bits
};

struct Trial {
  std::string name, group, title, source;
  std::vector<std::string> expected;  ///< what the scene must come to, in words
  std::string known_shortfall;        ///< the scene's; empty: it must hold
  int threads = 1;

  TrialEnding ending = TrialEnding::completed;
  std::string reason;  ///< the solver's words where it did not complete
  double seconds = 0;  ///< wall time of the first run
  long steps = 0, iterations = 0, cuts = 0;
  int most_iterations = 0;  ///< in one step
  double penetration = 0;   ///< largest, of the local mesh size
  /// Most that mechanical energy less the work of constraints ever lay above an earlier value, of the energy moved.
  double energy_growth = 0;
  double remainder = 0;               ///< of the energy ledger, of the energy moved
  bool grows = false, closes = true;  ///< growth and remainder beyond their limits and the rounding of positions
  double least_volume = 1;            ///< of a tetrahedron, of its volume at the start
  bool finite = true;                 ///< every position, velocity and energy is a number
  double intrusion = 0;            ///< deepest point of a block in another, of the local mesh size, where it was looked
  std::string intruder;            ///< "wedge in groove"
  std::vector<std::string> unmet;  ///< demands of the scene that were not met, with their figures
  std::vector<MomentPrint> prints;
  std::vector<TrialRepetition> repetitions;

  double iterations_per_step() const {
    return steps > 0 ? static_cast<double>(iterations) / static_cast<double>(steps) : 0;
  }
  bool passed() const;  ///< it has no faults
};

// What every scene is held to.
inline constexpr double most_penetration = 1e-3;    ///< of the local mesh size; of what geometry alone finds, too
inline constexpr double most_energy_growth = 1e-6;  ///< of the energy moved

/// One number for the whole course, that of another run with the same bits at every sampled moment and no other's (but
/// by a chance of 1 in 2⁶⁴): runs of other threads, processes and machines can be compared by it.
std::uint64_t fingerprint(const Trial& trial);

/// What did not hold, in words with figures; empty: the scene passes.
std::vector<std::string> faults(const Trial& trial);

struct TrialOptions {
  int threads = 1;      ///< at most
  bool repeat = false;  ///< run the scene twice more, on 1 and on 2 threads, which must give the same bits
};

/// Runs the scene. Whatever goes wrong in it stands in the trial; only Cancelled goes on to the caller.
Trial run_trial(const StabilityScene& scene, const TrialOptions& options, Progress& progress);

/// Least volume of a tetrahedron that may move, over its volume before the run; 1 where there is none.
double least_volume_ratio(const BodySet& bodies);

/// Whether all positions and velocities are numbers.
bool all_finite(const BodySet& bodies);

}  // namespace talus
