#include "orientation/set_statistics.hpp"

#include <algorithm>

namespace talus {

SetStatistics statistics_of(std::span<const MeasuredJoint> joints, std::vector<std::size_t> members, std::string name) {
  std::vector<Vec3> poles;
  for (const std::size_t member : members) poles.push_back(pole_of(joints[member].plane));
  return {std::move(name), std::move(members), fisher_mean(poles), axis_mean(poles)};
}

std::vector<SetStatistics> statistics_by_set(std::span<const MeasuredJoint> joints) {
  std::vector<std::pair<std::string, std::vector<std::size_t>>> sets;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    auto found = std::ranges::find_if(sets, [&](const auto& set) { return set.first == joints[i].set; });
    if (found == sets.end()) found = sets.insert(sets.end(), {joints[i].set, {}});
    found->second.push_back(i);
  }
  std::vector<SetStatistics> statistics;
  for (auto& [name, members] : sets) statistics.push_back(statistics_of(joints, std::move(members), name));
  return statistics;
}

std::vector<Vec3> poles_of(std::span<const MeasuredJoint> joints) {
  std::vector<Vec3> poles;
  for (const MeasuredJoint& joint : joints) poles.push_back(pole_of(joint.plane));
  return poles;
}

}  // namespace talus
