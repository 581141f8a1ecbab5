#pragma once

#include <array>
#include <string_view>

#include "base/vector.hpp"

/// Limit equilibrium of a block that rests on two planes: which planes hold it, where it goes, at what friction it
/// stays. Forces only, no moments, and no forces that the planes exert on each other through the block.
namespace talus {

/// How a block on two planes moves, in the words of the paper's Tables 1 and 2.
enum class WedgeMode { stable, line_1, line_2, plane_1, plane_2, torsional, free_fall };

/// "stable", "w1" and "w2" (down the planes' line, along it or against it), "p1" and "p2" (on one plane), "TTS"
/// (sliding on plane 2 and turning on it), "free fall".
constexpr std::string_view to_string(WedgeMode mode) {
  constexpr std::array<std::string_view, 7> words{"stable", "w1", "w2", "p1", "p2", "TTS", "free fall"};
  return words[static_cast<std::size_t>(mode)];
}

/// Unit vectors: both planes' normals into the block, and their line in Direction 1.
struct WedgePlanes {
  std::array<Vec3, 2> normals;
  Vec3 line;
};

/// What limit equilibrium says of a block before its friction is known. Forces are shares of its weight.
struct WedgeEquilibrium {
  WedgeMode kinematic = WedgeMode::free_fall;  ///< how it would move without friction; never stable or torsional
  Vec3 direction = Vec3::Zero();               ///< unit, of that motion
  double driving = 1;                          ///< along the direction
  double normal = 0;                           ///< sum over the planes that carry

  /// Resisting over driving force at a friction angle [degrees].
  double factor(double friction_angle) const;
  /// Degrees; 90 where nothing can hold the block.
  double critical_friction_angle() const;
  WedgeMode mode(double friction_angle) const;
  /// Of a sliding block, in units of gravity; negative where it slows down.
  double acceleration(double friction_angle) const { return driving * (1 - factor(friction_angle)); }
};

/// The block leaves a plane that gravity, or sliding down the other plane alone, moves it away from; where it can leave
/// neither it slides down their line (Goodman & Shi, Block Theory, 1985; factor of safety after Hoek & Bray, 1981).
/// `down` is the unit vector of gravity.
WedgeEquilibrium wedge_equilibrium(const WedgePlanes& planes, const Vec3& down);

}  // namespace talus
