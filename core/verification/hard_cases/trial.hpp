#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "bodies/body_set.hpp"
#include "model/tolerances.hpp"
#include "verification/hard_cases/hard_case.hpp"

/// Runs a hard case and measures what no scene may break (docs/hard_cases.md).
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

/// What a snapshot must have in common with that of another run: all bits of all positions, and iterations.
struct SnapshotHash {
  double time = 0;              ///< s
  long iterations = 0;          ///< so far
  std::uint64_t positions = 0;  ///< hash over all nodes
  bool operator==(const SnapshotHash&) const = default;
};

/// What did not hold.
struct Fault {
  FaultKind kind = FaultKind::expectation;
  std::string words;  ///< with figures
};

/// What came of running a scene once more.
struct TrialRepetition {
  int threads = 1;
  std::string difference;  ///< where the runs part; empty: the same bits
};

/// What came of running a scene at another place and at home again.
struct TrialElsewhere {
  double apart = 0;        ///< most that displacements of a block differ by, of the extent of all that moves
  std::string difference;  ///< beyond rounding; empty: the same
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
  double interpenetration = 0;   ///< deepest point of a block in another, of the local mesh size, where it was looked
  std::string interpenetrating;  ///< "wedge in groove"
  std::vector<Fault> unmet;      ///< expectations of the scene that were not met
  std::vector<Vec3> displacements;  ///< m, of the centroids of all blocks at the end
  std::vector<SnapshotHash> prints;
  std::vector<TrialRepetition> repetitions;
  std::optional<TrialElsewhere> elsewhere;  ///< where that was asked for, and the scene comes to one answer

  double iterations_per_step() const {
    return steps > 0 ? static_cast<double>(iterations) / static_cast<double>(steps) : 0;
  }
  bool passed() const;  ///< it has no faults
};

// What every scene is held to.
inline constexpr double most_penetration = 1e-3;      ///< of the local mesh size; of what geometry alone finds, too
inline constexpr double most_energy_growth = 1e-6;    ///< of the energy moved
inline constexpr double most_apart_elsewhere = 1e-9;  ///< of the extent of all that moves

/// One number for the whole run, that of another run with the same bits in every snapshot and no other's (but
/// by a chance of 1 in 2⁶⁴): runs of other threads, processes and machines can be compared by it.
std::uint64_t fingerprint(const Trial& trial);

/// What did not hold; empty: the scene passes.
std::vector<Fault> faults_by_kind(const Trial& trial);
/// The same in words alone.
std::vector<std::string> faults(const Trial& trial);

struct TrialOptions {
  int threads = 1;  ///< at most
  /// Run the scene once more on each of these numbers of threads, taken up anew 25 times from what was written of it
  /// (`solve --resume`): with the same bits.
  std::vector<int> repeat_on{};
  /// Run scenes that say where else they must come to the same there, and at home again.
  bool elsewhere = false;
  Tolerances tolerances{};
  /// SolverSettings::tolerance, in place of that of scenes that ask for none of their own.
  std::optional<double> tolerance{};
};

/// Runs the scene. Whatever goes wrong in it stands in the trial; only Cancelled goes on to the caller.
Trial run_trial(const HardCase& scene, const TrialOptions& options, Progress& progress);

/// Least volume of a tetrahedron that may move, over its volume before the run; 1 where there is none.
double least_volume_ratio(const BodySet& bodies);

/// Whether all positions and velocities are numbers.
bool all_finite(const BodySet& bodies);

}  // namespace talus
