#pragma once

#include <cstdint>
#include <iosfwd>

#include "results/frame.hpp"

namespace talus {

struct BlockSystem;

/// Number of VTK's cell type of four nodes.
inline constexpr std::uint8_t vtk_tetra = 10;

/// Writes one frame as a VTK XML unstructured grid with appended raw data, readable from VTK 6 on.
void write_vtu(std::ostream& stream, const BlockSystem& system, const Frame& frame);

}  // namespace talus
