#pragma once

#include <iosfwd>

#include "mesh/block.hpp"
#include "results/frame.hpp"

namespace talus {

/// Writes one frame as a VTK XML unstructured grid with appended raw data, readable from VTK 6 on.
void write_vtu(std::ostream& stream, const BlockSystem& system, const Frame& frame);

}  // namespace talus
