#pragma once

#include <optional>
#include <string>

#include "model/solver_settings.hpp"
#include "results/convergence_trouble.hpp"

namespace talus {

/// A block that is tiny beside the one that it touches, as cuts leave them.
struct Chip {
  std::string name;
  double thickness;  ///< m, as Splinters have it: twice the volume over the surface
};

/// What to change in the project so that the trial step of `length` [s] would be easier: one short phrase that fits the
/// cause. `chip`: one that is at the place.
std::string advice_for(const ConvergenceTrouble& trouble, double length, const SolverSettings& settings,
                       const std::optional<Chip>& chip = {});

}  // namespace talus
