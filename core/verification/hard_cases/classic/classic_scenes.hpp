#pragma once

#include <vector>

#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/hard_case.hpp"
#include "verification/hard_cases/shapes.hpp"

/// The classic scenes, a file each kind, and what they share.
namespace talus {

/// All of them.
std::vector<HardCase> classic_scenes();

std::vector<HardCase> erleben_scenes();
std::vector<HardCase> friction_scenes();
std::vector<HardCase> tight_fit_scenes();
std::vector<HardCase> stack_scenes();
std::vector<HardCase> arch_scenes();
std::vector<HardCase> card_house_scenes();
std::vector<HardCase> chain_scenes();
std::vector<HardCase> fast_scenes();
std::vector<HardCase> broken_wall_scenes();

Joint joint_of(const std::string& name, double friction_coefficient);

/// A scene of one material and one joint of that friction coefficient.
CaseScene scene_of(const Material& material, double friction_coefficient);

/// 2600 kg/m³, 50 GPa, 0.24.
Material hard_stone();

inline const char* const classic_group = "classic";

}  // namespace talus
