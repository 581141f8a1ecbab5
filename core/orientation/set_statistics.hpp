#pragma once

#include <span>
#include <string>
#include <vector>

#include "orientation/joint_table.hpp"
#include "orientation/mean_orientation.hpp"

namespace talus {

/// What the poles of one set say together.
struct SetStatistics {
  std::string name;                  ///< empty for joints without a set
  std::vector<std::size_t> members;  ///< numbers of its joints, ascending
  FisherMean fisher;
  AxisMean axis;

  PlaneAttitude mean_plane() const { return attitude_of_normal(fisher.pole); }
};

/// The sets in the order in which they first appear.
std::vector<SetStatistics> statistics_by_set(std::span<const MeasuredJoint> joints);

/// Of the joints of these numbers, at least one.
SetStatistics statistics_of(std::span<const MeasuredJoint> joints, std::vector<std::size_t> members, std::string name);

std::vector<Vec3> poles_of(std::span<const MeasuredJoint> joints);

}  // namespace talus
