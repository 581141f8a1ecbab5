#pragma once

#include <filesystem>
#include <string>

#include "measures/slide.hpp"

namespace talus {

/// Writes front.csv (time, advance and velocity of the front, volume that moved), blocks.csv (of those that moved),
/// deposit.csv (the corners of its outline, ring by ring) and depth.asc (its depth as a grid that GIS open). The folder
/// is made; it must be empty. Throws InputError when it is not or cannot be written.
void export_slide(const Slide& slide, const BlockSystem& system, const std::filesystem::path& folder);

/// The depth as an ESRI ASCII grid, rows from north to south.
std::string grid_text(const DepthGrid& grid);

}  // namespace talus
