#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "verification/hard_cases/trial.hpp"
#include "verification/random/random_scene.hpp"

/// Random scenes, as many as a user asks for, and what became of them family by family.
namespace talus {

/// Which scenes to draw.
struct RandomChoice {
  int count = 0;
  std::uint64_t seed = 1;
  std::vector<std::string> families{};  ///< empty: all
  std::optional<RandomBodies> bodies{};
  bool other_settings = false;
};

/// The names of `count` scenes: the families in turn, each counting from 1, so that more scenes of a seed begin with
/// the same ones. Throws InputError for a family there is not.
std::vector<RandomSceneName> random_scene_names(const RandomChoice& choice);

/// Draws and runs one after the other, and hands each on as it comes. Throws Cancelled when `progress` says so.
void verify_random(const std::vector<RandomSceneName>& names, const TrialOptions& options, Progress& progress,
                   const std::function<void(const HardCase&, const Trial&)>& ended);

/// What became of the scenes of a family.
struct FamilyResult {
  std::string family;
  int scenes = 0, held = 0;
  double seconds = 0;                 ///< of computing
  std::map<FaultKind, int> faults{};  ///< in how many scenes there was one of this kind
};

/// In the order in which families come first.
std::vector<FamilyResult> family_results(const std::vector<Trial>& trials);

/// "not converged 3, lost 1"
std::string faults_text(const FamilyResult& result);

}  // namespace talus
