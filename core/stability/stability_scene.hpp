#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/block_scene.hpp"

/// Scenes chosen to break contact codes, each with what must hold.
namespace talus {

/// How a run went, as a scene's own expectations look at it: all blocks at the start, at the end of every stage, and
/// often enough in between that no block moves far unseen.
struct Course {
  const BlockSystem& system;
  std::vector<Moment> moments;  ///< the first is the start, of stage −1

  int block(const std::string& name) const;  ///< index; throws std::logic_error where there is none
  const Moment& last() const { return moments.back(); }
  /// The last moment of a stage; −1: the start. Throws std::logic_error where the run did not come to it.
  const Moment& end_of_stage(int stage) const;
};

/// What a scene must come to: rests, slides, topples, falls.
struct Demand {
  std::string words;  ///< "the spike rests: moves by less than 1e-6 m"
  /// What was not so, with its figure; empty: it was so.
  std::function<std::string(const Course&)> fault;
};

/// One scene of the suite. The figures that every scene is held to (docs/stability.md) come on top of its expectations.
struct StabilityScene {
  std::string name;      ///< one_word, for the command line
  std::string group;     ///< "degenerate contact"
  std::string title;     ///< a line for tables
  std::string source{};  ///< of published parameters; empty: ours
  bool takes_long = false;
  /// Why it is known not to hold yet; empty: it holds. Whoever mends the cause takes it off: a scene that holds
  /// although it has one fails its test.
  std::string shortfall{};
  std::vector<Demand> expected;  ///< at least one
  std::function<CaseScene()> build;
};

/// The scene, and `times` more with gravity and initial velocities greater by 1e-10 of themselves, by 2e-10, …:
/// where blocks tumble, rounding decides what they meet, and what holds by chance alone does not hold. The others are
/// named "scene+1", "scene+2", ….
std::vector<StabilityScene> with_nudges(const StabilityScene& scene, int times);

}  // namespace talus
