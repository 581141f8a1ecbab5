#include "orientation/attitude.hpp"

#include <cmath>
#include <regex>

#include "base/error.hpp"
#include "model/number_text.hpp"

namespace talus {
namespace {

std::string short_number(double value) { return number_text(std::round(100 * value) / 100 + 0.0); }

}  // namespace

double azimuth_within_circle(double azimuth) {
  const double within = std::fmod(azimuth, 360.0);
  const double positive = within < 0 ? within + 360 : within;
  return positive >= 360 ? 0 : positive;  // a tiny negative azimuth rounds up to 360 itself
}

double azimuth_difference(double a, double b) {
  const double between = azimuth_within_circle(a - b);
  return between > 180 ? 360 - between : between;
}

PlaneAttitude upright(PlaneAttitude plane) {
  if (plane.dip > 90) plane = {180 - plane.dip, plane.dip_direction + 180};
  if (plane.dip < 0) plane = {-plane.dip, plane.dip_direction + 180};
  return {plane.dip, azimuth_within_circle(plane.dip_direction)};
}

double dip_direction_of_strike(double strike) { return azimuth_within_circle(strike + 90); }

Vec3 pole_of(const PlaneAttitude& plane) {
  const double tilt = radians(plane.dip), azimuth = radians(plane.dip_direction);
  return {-std::sin(tilt) * std::sin(azimuth), -std::sin(tilt) * std::cos(azimuth), -std::cos(tilt)};
}

Vec3 dip_vector_of(const PlaneAttitude& plane) { return direction_of({plane.dip_direction, plane.dip}); }

Vec3 direction_of(const LineAttitude& line) {
  const double fall = radians(line.plunge), azimuth = radians(line.trend);
  return {std::cos(fall) * std::sin(azimuth), std::cos(fall) * std::cos(azimuth), -std::sin(fall)};
}

PlaneAttitude attitude_of_normal(const Vec3& normal) {
  const LineAttitude pole = attitude_of(downward(normal));
  const double dip = 90 - pole.plunge;
  return {dip, dip > 0 ? azimuth_within_circle(pole.trend + 180) : 0};
}

Vec3 downward(const Vec3& line) { return line.z() > 0 ? Vec3(-line) : line; }

std::string plane_text(const PlaneAttitude& plane) {
  return short_number(plane.dip) + '/' + short_number(plane.dip_direction);
}

PlaneAttitude plane_from_text(const std::string& text, const std::string& place) {
  static const std::regex form(R"(\s*(\d+(?:\.\d+)?)\s*/\s*(\d+(?:\.\d+)?)\s*)");
  std::smatch part;
  if (!std::regex_match(text, part, form))
    throw InputError(place, "\"" + text + "\" is no plane", "write dip/dip direction in degrees, as in 45/120");
  const PlaneAttitude plane{std::stod(part[1]), std::stod(part[2])};
  if (plane.dip > 90 || plane.dip_direction > 360)
    throw InputError(place, "\"" + text + "\" has an angle out of its range",
                     "dips are 0 to 90, dip directions 0 to 360 degrees");
  return upright(plane);
}

}  // namespace talus
