#pragma once

#include "model/project.hpp"

namespace talus {

/// What repeats differ by, relative: as gravity does between two places 3 m above each other, or, in direction, 6 m
/// apart on the earth. No survey knows more.
inline constexpr double perturbation_share = 1e-6;

/// The project for the repeat of a run, from 0: the first is as it is. Of each other gravity and every initial velocity
/// differ by a vector that chance draws, each component up to `perturbation_share` of their length, and all point loads
/// by one factor: the same for the same repeat on every machine and under every setting.
Project perturbed(Project project, int repeat);

}  // namespace talus
