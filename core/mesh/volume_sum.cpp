#include "mesh/volume_sum.hpp"

#include <cmath>

namespace talus {

bool VolumeSum::adds_up() const {
  constexpr double rounding = 1e-6;  // of the solids' volume
  return std::abs(blocks - solids) <= rounding * solids;
}

VolumeSum volume_sum(const BlockSystem& system) {
  VolumeSum sum{0, system.solids_volume};
  for (const Block& block : system.blocks) sum.blocks += block.volume;
  return sum;
}

}  // namespace talus
