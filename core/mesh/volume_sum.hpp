#pragma once

#include "mesh/block.hpp"

namespace talus {

/// Volumes of blocks and of the solids that they were cut from [m³].
struct VolumeSum {
  double blocks = 0, solids = 0;
  /// To rounding: no rock was lost or made twice.
  bool adds_up() const;
};

VolumeSum volume_sum(const BlockSystem& system);

}  // namespace talus
