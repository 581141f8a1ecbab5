#pragma once

#include <optional>

#include "verification/hard_cases/trial.hpp"

namespace talus {

/// What is looked for when a scene is made smaller: a fault of the kind that breaks a law whatever the scene must come
/// to, the first there is in the trial; nothing where only expectations were not met.
std::optional<FaultKind> law_broken(const Trial& trial);

/// The scene with fewer steps and fewer blocks, as long as a fault of the kind is there: its stages are dropped and
/// halved from the end, then one block after the other that moves is left out, unless blocks are cut from solids.
/// `most_runs` at most. Throws Cancelled when `progress` says so.
CaseScene smaller_scene(const CaseScene& scene, FaultKind kind, int most_runs, const TrialOptions& options,
                        Progress& progress);

}  // namespace talus
