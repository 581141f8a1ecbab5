#pragma once

#include "model/solver_settings.hpp"
#include "model/tolerances.hpp"

namespace talus {

/// How contacts are found and how stiff they are.
struct ContactSettings {
  ContactModel model = ContactModel::area;
  double stiffness = 10;     ///< κ: k_n = κ E*/h [Pa/m], 1/E* = 1/E1 + 1/E2
  double shear_ratio = 0.4;  ///< k_s / k_n
  bool motion_told = false;  ///< moved() tells what moved; else detect() looks at all nodes of bodies that are awake
  ContactTolerances tolerances;
};

}  // namespace talus
