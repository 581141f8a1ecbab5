#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/vector.hpp"

/// Whether a block can leave its place, and how its weight would make it, by block theory: Goodman & Shi, Block Theory
/// and Its Application to Rock Engineering (1985), chapters 4, 6 and 9; Warburton, Int. J. Rock Mech. Min. Sci. 18
/// (1981) 415. Blocks around it stand still and nothing turns; only weight, friction and cohesion act.
namespace talus {

/// A plane in which the block lies against others.
struct HoldingPlane {
  Vec3 normal = Vec3::Zero();  ///< unit, out of the block
  double friction = 0;         ///< tan φ
  double cohesion = 0;         ///< N, of the whole area that touches
};

enum class Leaving {
  enclosed,  ///< no face is free and no direction is open
  tapered,   ///< a face is free, but no direction is open
  stable,    ///< directions are open, but its weight drives it in none
  falls,     ///< away from all planes, or along upright ones
  slides_on_one,
  slides_on_two,
};

/// The word that tables use.
constexpr std::string_view to_string(Leaving leaving) {
  constexpr std::string_view words[]{"enclosed",           "tapered", "stable", "falls", "slides on one face",
                                     "slides on two faces"};
  return words[static_cast<int>(leaving)];
}

struct Removability {
  Leaving leaving = Leaving::enclosed;
  Vec3 direction = Vec3::Zero();  ///< unit, in which it leaves; zero where it does not
  std::vector<int> on;            ///< planes it slides on, indices into those given
  /// Strength over driving force along `direction`, by limit equilibrium; none where nothing drives it.
  std::optional<double> factor;
  bool removable() const { return leaving > Leaving::tapered; }
};

/// `force`: N, the block's weight. The direction is that of all open ones that is nearest to the force, which is the
/// force's projection onto their cone; the planes that carry the rest of the force are slid on. Where more than two
/// planes can carry it, those two that give the least strength.
Removability removability(std::span<const HoldingPlane> planes, bool has_free_face, const Vec3& force);

}  // namespace talus
