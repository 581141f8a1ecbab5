#pragma once

#include "mesh/block.hpp"

namespace talus {

/// Volumes of blocks, of those that are excavated and splinters that are dropped, and of the solids that all of them
/// were cut from [m³].
struct VolumeSum {
  double blocks = 0, left_out = 0, solids = 0;
  /// To rounding: no rock was lost or made twice.
  bool adds_up() const;
};

VolumeSum volume_sum(const BlockSystem& system);

}  // namespace talus
