#pragma once

#include <cstdint>

namespace talus {

/// Number of VTK's cell type of four nodes.
inline constexpr std::uint8_t vtk_tetra = 10;

}  // namespace talus
