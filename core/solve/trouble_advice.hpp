#pragma once

#include <string>

#include "model/solver_settings.hpp"
#include "results/convergence_trouble.hpp"

namespace talus {

/// What to change in the project so that the trial step of `length` [s] would be easier: one short phrase that fits the
/// cause.
std::string advice_for(const ConvergenceTrouble& trouble, double length, const SolverSettings& settings);

}  // namespace talus
