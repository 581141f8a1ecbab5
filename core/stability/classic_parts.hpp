#pragma once

#include "stability/all_scenes.hpp"
#include "stability/expectations.hpp"
#include "stability/shapes.hpp"

/// The classic scenes, a file each kind, and what they share.
namespace talus {

std::vector<StabilityScene> erleben_scenes();
std::vector<StabilityScene> friction_scenes();
std::vector<StabilityScene> tight_fit_scenes();
std::vector<StabilityScene> stack_scenes();
std::vector<StabilityScene> arch_scenes();
std::vector<StabilityScene> card_house_scenes();
std::vector<StabilityScene> chain_scenes();
std::vector<StabilityScene> fast_scenes();
std::vector<StabilityScene> broken_wall_scenes();

Joint joint_of(const std::string& name, double friction_coefficient);

/// A scene of one material and one joint of that friction coefficient.
CaseScene scene_of(const Material& material, double friction_coefficient);

/// 2600 kg/m³, 50 GPa, 0.24.
Material hard_stone();

inline const char* const classic_group = "classic";

}  // namespace talus
