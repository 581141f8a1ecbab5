#pragma once

#include "model/project.hpp"

/// A bench of rock that random joint sets cut into blocks.
namespace talus {

enum class BenchEnd { slides, stands };

/// A slab above a bedding plane that dips west by 25° to 45°, on fixed bedrock: 40 m × 40 m, 12 m high. Its own bedding
/// cuts it, and a steep set to the south and one to the east, of random dip, dip direction and spacing: about
/// `planes` over the length of the bench. The same for the same seed on every machine.
struct JointedBench {
  int planes = 6;     ///< 6 make 94 to 176 blocks of the seeds up to 20, 12 some 700
  unsigned seed = 1;  ///< of all that is drawn
  BodyKind body = BodyKind::rigid;
  BenchEnd end = BenchEnd::slides;  ///< friction 5° to 15° below the dip of the bedding, or 10° above it

  double dip() const;             ///< of the bedding, degrees
  double friction_angle() const;  ///< degrees
  /// Solids, cuts, material and joint; no stages.
  Project project() const;
};

}  // namespace talus
