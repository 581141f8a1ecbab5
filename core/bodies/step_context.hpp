#pragma once

#include <limits>
#include <span>

#include "bodies/time_integration.hpp"

namespace talus {

/// Lever arms with which forces on rigid bodies become moments: those at the end of the step, as a potential has them;
/// or their mean over the step, by which a force does exactly the work of its displacement (docs/theory.md, "Turning
/// under load").
enum class Arms { end, mean };

/// The step that is about to be tried.
struct StepContext {
  double time = 0;                ///< s, at the start of the step
  double length = 0;              ///< s, Δ
  double dynamic_factor = 1;      ///< fraction of the velocity that enters the step: 0 static, 1 dynamic
  TimeIntegration integration{};  ///< of this step; in static stages all forces are taken at its end
  Arms arms = Arms::end;          ///< of all forces but those that must have a potential
  double extent = 0;              ///< m, largest coordinate: positions are rounded by 1e-16 of it
  double reach = std::numeric_limits<double>::infinity();  ///< m, the longest displacement of a node in one iteration
  std::span<const char> unlimited{};  ///< a body: whether that does not hold for it, for it is alone; empty: for none
  double mesh_size = 0;               ///< m, largest of blocks that may move: edges are rounded by 1e-16 of it
};

}  // namespace talus
