#pragma once

#include <vector>

#include "cases/known_case.hpp"

namespace talus {

/// Blocks that fall, slide, topple, rock, spin and strike; arches and columns of them.
std::vector<KnownCase> block_cases();
/// What tetrahedra must do as a continuum: patch tests, beam, wave, crack.
std::vector<KnownCase> continuum_cases();
/// Rock wedges: the roof wedge and the wedge tests in the mould block.
std::vector<KnownCase> wedge_cases();

/// All of them, from single blocks to whole series of tests. Names are unique.
std::vector<KnownCase> known_cases();

}  // namespace talus
