#pragma once

#include <optional>

#include "mesh/block.hpp"
#include "session/messages.hpp"

namespace talus {

/// Volumes of blocks and of the solids that they were cut from [m³].
struct VolumeSum {
  double blocks = 0, solids = 0;
  /// To rounding.
  bool addsUp() const;
};
VolumeSum volumeSum(const BlockSystem& system);

/// Rock that cutting has lost or made twice; none where the volumes add up, or blocks are left out on purpose.
std::optional<Problem> volumeProblem(const BlockSystem& system, const Project& project);

}  // namespace talus
