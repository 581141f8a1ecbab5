#pragma once

#include <filesystem>
#include <vector>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "mesh/block.hpp"

namespace talus {

class KeptMeshes;

/// Imports the project's solids, cuts them along its joints, names the blocks and meshes each with tetrahedra.
/// A block of body 'auto' gets the body that `BodyChooser` chooses, with the reason. Rigid and affine blocks without a
/// mesh size are meshed from their corners alone, others to a tenth of their solid's longest side.
/// gmsh runs in a child process: cancelling kills it, and a crash in it is an InputError here.
/// `folder`: where the project file lies; paths in the project are relative to it.
/// Names: a solid's own when it stays in one piece, else NAME.1, NAME.2, … by the pieces' centroids (x, then y, then z,
/// ascending); an override's name replaces one of these, the others keep their numbers, also where pieces are removed,
/// merged or dropped.
/// A project that is still being set up is cut, too: it may lack stages and the default joint.
/// Throws InputError for what the user can mend (what `validate_for_cutting` refuses, overlapping solids, a cut that
/// misses, a file that cannot be read, an override in no block, a mesh of more tetrahedra than the project allows),
/// SplintersFound for splinters that are refused, Cancelled when `progress` says so.
BlockSystem build_blocks(const Project& project, const std::filesystem::path& folder, Progress& progress);

/// The same blocks, bit for bit; those whose meshes are kept are not meshed again, and theirs are kept for the next
/// time.
BlockSystem build_blocks(const Project& project, const std::filesystem::path& folder, Progress& progress,
                         KeptMeshes& kept);

/// The same, but meshed from their corners alone, however fine the project wants them: what the blocks look like, and
/// what `mesh_estimate` needs. Curved faces keep the usual size.
BlockSystem cut_blocks(const Project& project, const std::filesystem::path& folder, Progress& progress);

/// What is wrong with the files that solids are read from, each looked at by itself; nothing is cut. Throws Cancelled.
/// The place of each is "/solids/N/file".
std::vector<InputError> broken_files(const Project& project, const std::filesystem::path& folder, Progress& progress);

/// Whether blocks built of one project serve the other: they are cut, named, meshed and, where a body is 'auto', chosen
/// alike. Both have been validated.
bool build_alike(const Project& a, const Project& b);

}  // namespace talus
