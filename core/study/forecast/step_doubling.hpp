#pragma once

#include <optional>

#include "base/progress.hpp"
#include "model/project.hpp"

namespace talus {

struct BlockSystem;

/// How often a run is paid for to know this of it: once as it is, and in twice as many steps.
constexpr double cost_of_step_doubling = 3;

/// What the steps of a run leave out of where its nodes are, strain and vibration included, over the longest
/// displacement of a node: the run, and the same with dynamic stages in steps half as long; the largest difference at
/// the quarters of these stages, extrapolated by the order of the integrator (Richardson 1911). Nothing where one of
/// both comes to no end, or takes more than `budget` [s of the processor], or nothing moves. Throws InputError as
/// Simulation does, Cancelled.
std::optional<double> error_by_step_doubling(const Project& project, const BlockSystem& system, double budget,
                                             Progress& progress);

}  // namespace talus
