#include "orientation/set_window.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <regex>

#include "base/error.hpp"

namespace talus {
namespace {

constexpr double rounding = 1e-9;  // degrees: a plane on the border of a window is in it

/// Acute angle between two axes, degrees; by the arc tangent, which stays exact for small ones.
double angle_between_axes(const Vec3& a, const Vec3& b) {
  return degrees(std::atan2(a.cross(b).norm(), std::abs(a.dot(b))));
}

bool direction_within(const RangeWindow& window, double direction) {
  const double width = window.direction_to - window.direction_from;
  if (width >= 360) return true;
  return azimuth_within_circle(direction - window.direction_from + rounding) <=
         azimuth_within_circle(width) + 2 * rounding;
}

bool within(const RangeWindow& window, double dip, double direction) {
  return dip >= window.dip_from - rounding && dip <= window.dip_to + rounding && direction_within(window, direction);
}

bool holds(const ConeWindow& window, const Vec3& pole) {
  return angle_between_axes(pole, pole_of(window.centre)) <= window.half_angle + rounding;
}

bool holds(const RangeWindow& window, const Vec3& pole) {
  const PlaneAttitude plane = attitude_of_normal(pole);
  if (plane.dip < rounding) return window.dip_from <= rounding;  // a level plane dips towards all directions
  return within(window, plane.dip, plane.dip_direction) || within(window, 180 - plane.dip, plane.dip_direction + 180);
}

}  // namespace

bool contains(const SetWindow& window, const Vec3& pole) {
  return std::visit([&](const auto& shape) { return holds(shape, pole); }, window);
}

std::vector<std::size_t> picked(const SetWindow& window, std::span<const Vec3> poles) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < poles.size(); ++i)
    if (contains(window, poles[i])) numbers.push_back(i);
  return numbers;
}

SetWindow window_from_text(const std::string& text, const std::string& place) {
  static const std::regex cone(R"(([^~]+)~\s*(\d+(?:\.\d+)?)\s*)");
  static const std::string number = R"(\s*(\d+(?:\.\d+)?)\s*)", span = number + R"(\.\.)" + number;
  static const std::regex range(span + "/" + span);
  std::smatch part;
  if (std::regex_match(text, part, cone)) {
    const ConeWindow window{plane_from_text(part[1], place), std::stod(part[2])};
    if (window.half_angle <= 90) return window;
    throw InputError(place, "a cone of " + part[2].str() + "° is wider than the net", "take at most 90");
  }
  if (!std::regex_match(text, part, range))
    throw InputError(place, "\"" + text + "\" is no window",
                     "write a cone about a plane, 45/120~15, or ranges of dip and direction, 30..60/100..140");
  const RangeWindow window{std::stod(part[1]), std::stod(part[2]), std::stod(part[3]), std::stod(part[4])};
  if (window.dip_from > window.dip_to || window.dip_to > 180)
    throw InputError(place, "the dips " + part[1].str() + ".." + part[2].str() + " are no range",
                     "write the smaller first, at most 180 (above 90: planes that dip the other way)");
  if (window.direction_from > 360 || window.direction_to > 360)
    throw InputError(place, "a dip direction above 360", "write directions of 0 to 360");
  return window;
}

std::string window_text(const SetWindow& window) {
  const auto half = [](double first, double second, const char* between) {  // plane_text knows how to write numbers
    std::string text = plane_text({first, second});
    return text.replace(text.find('/'), 1, between);
  };
  if (const auto* cone = std::get_if<ConeWindow>(&window))
    return plane_text(cone->centre) + half(0, cone->half_angle, "~").substr(1);
  const auto& range = std::get<RangeWindow>(window);
  return half(range.dip_from, range.dip_to, "..") + '/' + half(range.direction_from, range.direction_to, "..");
}

}  // namespace talus
