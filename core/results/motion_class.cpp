#include "results/motion_class.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/line_attitude.hpp"
#include "mesh/block.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

std::string name_of(int number, const std::vector<std::string>& names) {
  const auto at = static_cast<std::size_t>(number);
  return at < names.size() ? names[at] : "";
}

/// "J1 (B1)" of the first or second plane.
std::string plane_text(const MotionClass& motion, std::size_t plane, const MotionNames& names) {
  const std::string joint = name_of(motion.joints[plane], names.joints);
  const std::string block = name_of(motion.against[plane], names.blocks);
  if (joint.empty()) return block;
  return block.empty() ? joint : joint + " (" + block + ")";
}

std::string words_of(const MotionClass& motion, const MotionNames& names) {
  const std::string first = plane_text(motion, 0, names);
  switch (motion.mode) {
    case MotionMode::stable:
    case MotionMode::falling:
      break;
    case MotionMode::carried:
      return "carried by " + name_of(motion.against[0], names.blocks);
    case MotionMode::sliding_on_one:
      return "sliding on " + first;
    case MotionMode::sliding_on_two:
      return "sliding on " + first + " and " + plane_text(motion, 1, names) + " along " + attitude_text(motion.line);
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

Json attitude_json(const Vec3& direction) {
  if (direction.isZero()) return nullptr;
  const LineAttitude attitude = attitude_of(direction);
  return {{"trend", attitude.trend}, {"plunge", attitude.plunge}};
}

/// Without those that are not there.
Json names_json(const std::array<int, 2>& numbers, const std::vector<std::string>& names) {
  Json list = Json::array();
  for (const int number : numbers)
    if (const std::string name = name_of(number, names); !name.empty()) list.push_back(name);
  return list;
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

MotionNames motion_names(const BlockSystem& system) {
  MotionNames names;
  for (const Block& block : system.blocks) names.blocks.push_back(block.name);
  names.joints = system.joint_names;
  return names;
}

std::string motion_text(const MotionClass& motion, const MotionNames& names) {
  return words_of(motion, names) + (motion.came_to_rest ? ", came to rest" : "");
}

std::string motion_json(const MotionClass& motion, const MotionNames& names) {
  Json object = {{"mode", to_string(motion.mode)},
                 {"text", motion_text(motion, names)},
                 {"came_to_rest", motion.came_to_rest},
                 {"joints", names_json(motion.joints, names.joints)},
                 {"against", names_json(motion.against, names.blocks)},
                 {"trend", nullptr},
                 {"plunge", nullptr},
                 {"line", attitude_json(motion.line)},
                 {"axis", attitude_json(motion.axis)},
                 {"rotation_share", motion.rotation_share}};
  if (const Json direction = attitude_json(motion.direction); direction.is_object()) object.update(direction);
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string attitude_text(const Vec3& direction) {
  if (direction.isZero()) return "";
  const LineAttitude attitude = attitude_of(direction);
  char text[32];
  // 359.96° is 0°, and a level line plunges by 0°, not by −0°.
  std::snprintf(text, sizeof text, "%03.0f°/%.0f°", std::fmod(std::round(attitude.trend), 360),
                std::round(attitude.plunge) + 0.0);
  return text;
}

}  // namespace talus
