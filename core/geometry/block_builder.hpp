#pragma once

#include <filesystem>

#include "base/progress.hpp"
#include "mesh/block.hpp"

namespace talus {

/// Imports the project's solids, cuts them along its joints, names the blocks and meshes each with tetrahedra.
/// gmsh runs in a child process: cancelling kills it, and a crash in it is an InputError here.
/// `folder`: where the project file lies; paths in the project are relative to it.
/// Names: a solid's own when it stays in one piece, else NAME.1, NAME.2, … by the pieces' centroids (x, then y, then z,
/// ascending); an override's name replaces one of these, the others keep their numbers.
/// Throws InputError for what the user can mend (what `validate` refuses, overlapping solids, a cut that misses,
/// a file that is not STEP, an override in no block), Cancelled when `progress` says so.
BlockSystem build_blocks(const Project& project, const std::filesystem::path& folder, Progress& progress);

}  // namespace talus
