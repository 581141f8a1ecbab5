#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "templates/shapes.hpp"
#include "templates/structures.hpp"

namespace talus {

namespace {

constexpr double length_over_height = 2, thickness_over_height = 1.5;  // of a stone

/// Courses of stones in running bond on a ground that is tilted across the wall, as on a tilting table: gravity is
/// turned in its place. The wall overturns where tan of the tilt exceeds thickness over height, and slides where the
/// tilt exceeds the friction angle.
Project make_dry_stone_wall(const TemplateValues& values) {
  const double height = values.at("stone_height"), tilt = radians(values.at("tilt"));
  const int courses = static_cast<int>(values.at("courses")), stones = static_cast<int>(values.at("stones"));
  const double length = length_over_height * height, half = thickness_over_height * height / 2;
  const double end = stones * length, high = courses * height;
  Project project = rock_with_joints("Dry-stone wall", values.at("friction"));
  project.gravity = 9.81 * Vec3(0, std::sin(tilt), -std::cos(tilt));
  project.solids = {fixed_rock(
      "ground", BoxShape{{-length, -half - length, -height}, {end + length, half + high + length, 0}}, length)};
  for (int course = 0; course < courses; ++course) {
    const bool halves = course % 2 == 1;
    const int count = stones + (halves ? 1 : 0);
    for (int i = 0; i < count; ++i) {
      const double from = halves ? std::max(0.0, (i - 0.5) * length) : i * length;
      const double to = halves ? std::min(end, (i + 0.5) * length) : (i + 1) * length;
      const std::string name = "stone " + std::to_string(course + 1) + "-" + std::to_string(i + 1);
      const BoxShape box{{from, -half, course * height}, {to, half, (course + 1) * height}};
      project.solids.push_back(free_rock(name, box));
    }
  }
  const std::string top = "stone " + std::to_string(courses) + "-1";
  add_monitor(project, top, {0, 0, high});
  add_stages(project, height, std::sqrt(high));
  return project;
}

}  // namespace

ProjectTemplate dry_stone_wall() {
  return {"dry-stone-wall",
          "Dry-stone wall",
          "Stones in running bond on tilted ground. The wall overturns where the tangent of the tilt exceeds thickness "
          "over height, and slides where the tilt exceeds the friction angle.",
          {{"courses", "Courses", "one above the other", "", 1, 10, 5, true},
           {"stones", "Stones", "in a course", "", 1, 10, 4, true},
           {"stone_height", "Stone height", "of a course; a stone is twice as long and 1.5 times as thick", "m", 0.1, 2,
            0.3},
           {"tilt", "Tilt", "of the ground, across the wall", "°", 0, 40, 0},
           {"friction", "Friction angle", "between stones", "°", 0, 60, 35}},
          make_dry_stone_wall};
}

}  // namespace talus
