#pragma once

#include <string>
#include <vector>

#include "effects/effect_kind.hpp"

namespace talus {

struct BlockSystem;
struct Project;

/// The counts that the cost of a scene's effects follows. Fixed blocks cost nothing and are not counted.
struct SceneSize {
  long tetrahedra = 0;     ///< of blocks of body tetrahedra
  long affine_blocks = 0;  ///< each of them one element
  long rigid_blocks = 0;
  long movable_blocks = 0;                                         ///< of any body
  long neo_hookean_tetrahedra = 0, neo_hookean_affine_blocks = 0;  ///< of them, those whose rock has that law
  long loose_points = 0;    ///< contact points without a bond that one detection at the start finds …
  long bonded_points = 0;   ///< … and those with one
  long sheared_points = 0;  ///< of both, those that can bear shear
};

/// Looks for contacts once, as the first step will, and takes no step; a project without a stage has no first step, and
/// no contact points. Throws InputError as Simulation does.
SceneSize scene_size(const Project& project, const BlockSystem& system);

/// An effect of called_effects() before the run: whether it is on, why, and what that costs.
struct EffectCost {
  EffectKind kind = EffectKind::elasticity;
  bool active = false;
  std::string reason;
  std::string items;   ///< what is paid for, "1 240 tetrahedra, 2 rigid blocks"; empty where it is off
  double seconds = 0;  ///< wall time of an open–close iteration on one thread, within a factor of two or so
};

/// Forces and stiffness alone: finding contacts and solving the equations come on top. Costs no solving.
std::vector<EffectCost> effect_costs(const Project& project, const BlockSystem& system, const SceneSize& size);

}  // namespace talus
