#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"

namespace talus {

struct BlockSystem;

/// How a block moves, in the terms of block theory (Goodman & Shi 1985) with toppling and torsion beside them.
enum class MotionMode : std::uint8_t {
  stable,
  carried,         ///< rides on a block that moves, without moving on it
  falling,         ///< no contact carries it
  sliding_on_one,  ///< on one plane
  sliding_on_two,  ///< along the line in which two planes meet
  toppling,
  torsional,  ///< turning in the plane it lies on, about that plane's normal
  sliding_and_toppling,
  sliding_and_torsional
};

/// The word that summary.json uses.
std::string_view to_string(MotionMode mode);

/// A block's motion over the last part of its travel. What a mode does not have is −1 or zero.
struct MotionClass {
  MotionMode mode = MotionMode::stable;
  bool came_to_rest = false;           ///< it has moved in this way and stands still now
  std::array<int, 2> joints{-1, -1};   ///< of the planes it slides on, or the one it topples or turns on
  std::array<int, 2> against{-1, -1};  ///< blocks on the other side of these planes; the first one for a block carried
  Vec3 direction = Vec3::Zero();       ///< unit, of the centroid's displacement
  Vec3 line = Vec3::Zero();            ///< unit, of the two planes' intersection, in the direction the block goes
  Vec3 axis = Vec3::Zero();            ///< unit, that the block turns about, right-handed
  double rotation_share = 0;           ///< 0 … 1, of the travel that turning makes beside sliding
  bool operator==(const MotionClass&) const = default;

  void archive(auto& state) { state(mode, came_to_rest, joints, against, direction, line, axis, rotation_share); }
};

/// Both name a plane by its joint and by the block on the other side.
bool same_kind(const MotionClass& a, const MotionClass& b);

/// What a class's numbers stand for.
struct MotionNames {
  std::vector<std::string> blocks, joints;
};
MotionNames motion_names(const BlockSystem& system);

/// "sliding on J1 (B1) and J2 (B3) along 120°/35°", "toppling on J5 (B2), came to rest".
std::string motion_text(const MotionClass& motion, const MotionNames& names);

/// An object: mode, came_to_rest, text, joints and against by name, trend and plunge of the direction, line and axis
/// likewise, rotation_share; null for what the mode does not have.
std::string motion_json(const MotionClass& motion, const MotionNames& names);

/// Trend and plunge, "120°/35°"; empty where a block goes nowhere.
std::string attitude_text(const Vec3& direction);

}  // namespace talus
