#pragma once

#include <cstdint>

#include "mesh/block.hpp"

namespace talus {

/// A number that two systems of blocks share where nodes, tetrahedra, surfaces, bodies and materials are the same to
/// the bit, and others but by a chance of 1 in 2⁶⁴ do not.
std::uint64_t digest(const BlockSystem& system);

}  // namespace talus
