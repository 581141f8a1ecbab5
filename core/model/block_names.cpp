#include "model/block_names.hpp"

#include <algorithm>

namespace talus {

std::vector<std::string> expected_block_names(const Project& project) {
  std::vector<std::string> names;
  for (const auto& block : project.blocks) names.push_back(block.name);
  for (const auto& solid : project.solids) names.push_back(solid.name);
  return names;
}

InputError point_outside_block(const std::string& place, const std::string& block) {
  return {place, "the point lies outside block '" + block + "'", "choose a point inside the block"};
}

bool may_be_block_name(const Project& project, const std::string& name) {
  const auto names = expected_block_names(project);
  if (std::find(names.begin(), names.end(), name) != names.end()) return true;

  const auto dot = name.rfind('.');
  if (dot == std::string::npos || dot + 1 == name.size()) return false;
  if (name.find_first_not_of("0123456789", dot + 1) != std::string::npos) return false;
  return std::any_of(project.solids.begin(), project.solids.end(),
                     [&](const Solid& solid) { return solid.name == name.substr(0, dot); });
}

}  // namespace talus
