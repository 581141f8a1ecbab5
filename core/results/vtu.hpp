#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "mesh/block.hpp"
#include "results/frame.hpp"

namespace talus {

/// Writes a frame as VTK's XML unstructured grid (ASCII, digits that read back exactly), which ParaView and others
/// open: displaced tetrahedra with displacement [m], velocity [m/s], stress [Pa; xx, yy, zz, xy, yz, zx], von Mises
/// stress [Pa] and the block's number. Throws std::runtime_error with the path when the file cannot be written.
void write_vtu(const BlockSystem& system, const Frame& frame, const std::filesystem::path& file);

/// The index of a series: each file's name, as seen from the index, with its time [s]. Errors as write_vtu.
void write_pvd(const std::vector<std::pair<double, std::string>>& frames, const std::filesystem::path& file);

}  // namespace talus
