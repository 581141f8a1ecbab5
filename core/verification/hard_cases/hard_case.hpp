#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/hard_cases/elsewhere.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

/// Scenes chosen to break contact codes, each with what must hold.
namespace talus {

/// All nodes of all blocks at one time, in BlockSystem's order.
struct NodeStates {
  std::vector<Vec3> positions, velocities;  ///< m, m/s
};

/// Where all blocks went in a run, as a scene's own expectations look at it: at the start, at the end of every stage,
/// and often enough in between that no block moves far unseen.
struct Trajectory {
  const BlockSystem& system;
  std::vector<Snapshot> snapshots;  ///< the first is the start, of stage −1
  std::vector<NodeStates> nodes{};  ///< one a snapshot, where the scene asks for them; else none

  int block(const std::string& name) const;  ///< index; throws std::logic_error where there is none
  const Snapshot& last() const { return snapshots.back(); }
  /// The last snapshot of a stage; −1: the start. Throws std::logic_error where the run did not come to it.
  const Snapshot& end_of_stage(int stage) const;
};

/// What may not hold of a run, to count by.
enum class FaultKind {
  not_converged,
  broken_off,
  not_finite,
  penetration,
  interpenetration,
  energy,
  ledger,
  inverted,
  lost,         ///< a body went through what is to stop it, or left what encloses it
  momentum,     ///< linear or angular, of bodies that nothing else touches
  expectation,  ///< whatever else a scene must come to
  other_bits,   ///< on another number of threads
  other_place,  ///< not the same at another place
};

/// The word for tables and JSON.
std::string_view to_string(FaultKind kind);

/// What a scene must come to: it rests, slides, topples or falls.
struct HardCaseExpectation {
  std::string words;  ///< "the spike rests: moves by less than 1e-6 m"
  /// What was not so, with its figure; empty: it was so.
  std::function<std::string(const Trajectory&)> fault;
  FaultKind kind = FaultKind::expectation;  ///< that a fault is counted as
};

/// A scene chosen to break contact codes. The figures that every scene is held to (docs/hard_cases.md) come on top of
/// its expectations.
struct HardCase {
  std::string name;      ///< one_word, for the command line
  std::string group;     ///< "degenerate contact"
  std::string title;     ///< a line for tables
  std::string source{};  ///< of published parameters; empty: ours
  bool takes_long = false;
  /// Why it is known not to hold yet; empty: it holds. Whoever mends the cause takes it off: a scene that holds
  /// although it has one fails its test.
  std::string shortfall{};
  std::vector<HardCaseExpectation> expected;  ///< at least one
  std::function<CaseScene()> build;
  bool has_blows = false;  ///< which make much of rounding
  /// Where else it must come to the same; nowhere where there are blows.
  std::optional<Elsewhere> elsewhere{};
  bool keeps_nodes = false;  ///< its expectations look at Trajectory::nodes, which take memory
};

/// The scene, and `times` more with gravity and initial velocities greater by 1e-10 of themselves, by 2e-10, …:
/// where blocks tumble, rounding decides what they strike, and what holds by chance alone does not hold. The others are
/// named "scene+1", "scene+2", ….
std::vector<HardCase> with_perturbations(const HardCase& scene, int times);

}  // namespace talus
