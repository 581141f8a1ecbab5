#pragma once

#include <vector>

#include "verification/known_answers/support/known_case.hpp"

namespace talus {

/// Blocks that fall, slide, topple, rock, spin and strike; arches and columns of them.
std::vector<KnownCase> block_cases();

// The groups that it joins, a file each; those whose theory stands in a header are declared there.
/// One block on an incline: slides at Coulomb's acceleration, sticks below its friction angle whatever happens
/// elsewhere, stops where its energy is used up.
std::vector<KnownCase> sliding_cases();
/// The semicircular arch under its own weight: runs just above and just below its least thickness.
std::vector<KnownCase> arch_cases();
/// Blocks that must stay, or stay just so: a slope of many blocks, bricks that overhang, cards that lean.
std::vector<KnownCase> resting_cases();
/// A column that is let go on an edge.
std::vector<KnownCase> rocking_cases();
/// A block that falls and rebounds.
std::vector<KnownCase> bouncing_cases();

}  // namespace talus
