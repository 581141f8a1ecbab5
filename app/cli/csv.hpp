#pragma once

#include <filesystem>

#include "mesh/block.hpp"
#include "results/frame.hpp"

namespace talus::cli {

/// Writes a frame as three tables beside each other: STEM-nodes.csv (block, node, position, displacement [m],
/// velocity [m/s]), STEM-tetrahedra.csv (block, tetrahedron, nodes, stress [Pa]) and STEM-contacts.csv (blocks, joint,
/// position, normal, state, forces [N], area [m²]). Throws InputError when a file cannot be written.
void write_csv(const BlockSystem& system, const Frame& frame, const std::filesystem::path& stem);

}  // namespace talus::cli
