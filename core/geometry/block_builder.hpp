#pragma once

#include <filesystem>

#include "base/progress.hpp"
#include "mesh/block.hpp"

namespace talus {

/// Imports the project's solids, cuts them along its joints, names the blocks and meshes each with tetrahedra.
/// gmsh runs in a child process: cancelling kills it, and a crash in it is an InputError here.
/// `folder`: where the project file lies; paths in the project are relative to it.
/// Throws InputError for what the user can mend (open polyhedra, overlapping solids, a cut that misses,
/// a file that is not STEP), Cancelled when `progress` says so.
BlockSystem build_blocks(const Project& project, const std::filesystem::path& folder, Progress& progress);

}  // namespace talus
