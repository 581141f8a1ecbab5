#include "mesh/volume_sum.hpp"

#include <cmath>

namespace talus {

bool VolumeSum::adds_up() const {
  constexpr double rounding = 1e-6;  // of the solids' volume
  return std::abs(blocks + left_out - solids) <= rounding * solids;
}

VolumeSum volume_sum(const BlockSystem& system) {
  VolumeSum sum{.blocks = 0, .left_out = system.excavated_volume, .solids = system.solids_volume};
  for (const Block& block : system.blocks) sum.blocks += block.volume;
  for (const Splinter& splinter : system.splinters)
    if (splinter.fate == Splinter::Fate::dropped) sum.left_out += splinter.volume;
  return sum;
}

}  // namespace talus
