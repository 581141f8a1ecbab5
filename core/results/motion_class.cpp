#include "results/motion_class.hpp"

#include <cstdio>

#include "base/line_attitude.hpp"
#include "mesh/block.hpp"

namespace talus {

namespace {

/// "J1 (B1)" of the first or second plane.
std::string plane_text(const MotionClass& motion, std::size_t plane, const BlockSystem& system) {
  const auto joint = static_cast<std::size_t>(motion.joints[plane]);
  const auto block = static_cast<std::size_t>(motion.against[plane]);
  const std::string other = block < system.blocks.size() ? system.blocks[block].name : "";
  if (joint >= system.joint_names.size()) return other;
  return other.empty() ? system.joint_names[joint] : system.joint_names[joint] + " (" + other + ")";
}

std::string words_of(const MotionClass& motion, const BlockSystem& system) {
  const std::string first = plane_text(motion, 0, system);
  switch (motion.mode) {
    case MotionMode::stable:
    case MotionMode::falling:
      break;
    case MotionMode::carried: {
      const auto carrier = static_cast<std::size_t>(motion.against[0]);
      return carrier < system.blocks.size() ? "carried by " + system.blocks[carrier].name : "carried";
    }
    case MotionMode::sliding_on_one:
      return "sliding on " + first;
    case MotionMode::sliding_on_two:
      return "sliding on " + first + " and " + plane_text(motion, 1, system) + " along " + direction_text(motion.line);
    case MotionMode::toppling:
    case MotionMode::torsional:
      return std::string(to_string(motion.mode)) + " on " + first;
    case MotionMode::sliding_and_toppling:
      return "sliding on " + first + " and toppling";
    case MotionMode::sliding_and_torsional:
      return "sliding on " + first + " and turning on it";
  }
  return std::string(to_string(motion.mode));
}

}  // namespace

std::string_view to_string(MotionMode mode) {
  constexpr std::string_view words[] = {"stable",
                                        "carried",
                                        "falling",
                                        "sliding on one plane",
                                        "sliding on two planes",
                                        "toppling",
                                        "torsional",
                                        "sliding and toppling",
                                        "sliding and torsional"};
  return words[static_cast<std::size_t>(mode)];
}

bool same_kind(const MotionClass& a, const MotionClass& b) {
  return a.mode == b.mode && a.came_to_rest == b.came_to_rest && a.joints == b.joints && a.against == b.against;
}

std::string motion_text(const MotionClass& motion, const BlockSystem& system) {
  return words_of(motion, system) + (motion.came_to_rest ? ", came to rest" : "");
}

std::string direction_text(const Vec3& direction) {
  if (direction.isZero()) return "";
  const LineAttitude attitude = attitude_of(direction);
  char text[32];
  // 359.96° is 0°, and a level line plunges by 0°, not by −0°.
  std::snprintf(text, sizeof text, "%03.0f°/%.0f°", std::fmod(std::round(attitude.trend), 360),
                std::round(attitude.plunge) + 0.0);
  return text;
}

}  // namespace talus
