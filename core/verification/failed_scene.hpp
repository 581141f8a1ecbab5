#pragma once

#include <filesystem>

#include "verification/hard_cases/trial.hpp"

namespace talus {

/// The scene as a project that anybody can open: blocks become solids, their surfaces polyhedra of triangles, unless
/// the project has solids that they were cut from. Meshes are made anew when it is run.
Project project_of(const CaseScene& scene);

/// Writes the scene into FOLDER/impacts-17-42.talus, where that is its name, with what did not hold in comments above.
/// Where a law is broken it is made smaller first, in 30 more runs at most. Makes the folder. Throws InputError where
/// it cannot be written.
std::filesystem::path write_failed_scene(const std::filesystem::path& folder, const HardCase& scene, const Trial& trial,
                                         const TrialOptions& options, Progress& progress);

}  // namespace talus
