#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "results/result_folder.hpp"

/// Results as other programs read them.
namespace talus {

/// Writes the frames of these numbers as frame_00000.vtu … and frames.pvd, the collection in time that ParaView opens:
/// the moved mesh with displacement, velocity, stress, von Mises stress, block and material. XML with its numbers in
/// base64 and 64-bit headers. The folder is made; it must be empty. Throws InputError when it is not or cannot be
/// written, Cancelled.
void export_vtu(const ResultReader& results, std::span<const int> frames, const std::filesystem::path& folder,
                Progress& progress);

/// Writes blocks.csv, history.csv, steps.csv, events.csv, frames.csv (times) and for the frames of these numbers
/// nodes_00000.csv …, tetrahedra_00000.csv …, contacts_00000.csv …, motions_00000.csv …, how blocks move, and
/// travels_00000.csv …, how far they went; headers name the units, numbers read back exactly. The folder is made; it
/// must be empty. Throws InputError when it is not or cannot be written, Cancelled.
void export_csv(const ResultReader& results, std::span<const int> frames, const std::filesystem::path& folder,
                Progress& progress);

/// The bytes of a binary STL file: the surface of all blocks where they are in the frame. Single precision, m.
std::string stl_of(const BlockSystem& system, const Frame& frame);

/// sRGB, 0 to 1.
using BlockColour = std::array<double, 3>;

/// The bytes of a binary glTF 2.0 file (.glb): a node with a mesh a block, in the block's colour, as they are in the
/// frame. Lengths in m, y up as glTF has it.
std::string glb_of(const BlockSystem& system, const Frame& frame, std::span<const BlockColour> colours);

/// The same with all frames as an animation, in seconds of the model: blocks have the shape that they were cut with,
/// and move and turn as a whole. Throws InputError where the results hold no frame, Cancelled.
std::string animated_glb_of(const ResultReader& results, std::span<const BlockColour> colours, Progress& progress);

}  // namespace talus
