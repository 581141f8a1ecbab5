#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "orientation/attitude.hpp"

/// Windows on the net that pick the poles of a set. A pole has no sense: a window that reaches over the net's rim
/// (steep planes that dip one way and the other) goes on at the opposite side.
namespace talus {

/// All poles within an angle of the pole of a plane.
struct ConeWindow {
  PlaneAttitude centre;
  double half_angle = 0;  ///< degrees, 0 … 90
  bool operator==(const ConeWindow&) const = default;
};

/// All planes of a range of dips and of dip directions. Dips above 90 are planes that dip the other way: 70 … 110 holds
/// those of 70 … 90 towards the directions, and those of 70 … 90 towards the opposite ones.
struct RangeWindow {
  double dip_from = 0, dip_to = 90;               ///< degrees, 0 … 180
  double direction_from = 0, direction_to = 360;  ///< clockwise from … to, across north where from > to
  bool operator==(const RangeWindow&) const = default;
};

using SetWindow = std::variant<ConeWindow, RangeWindow>;

bool contains(const SetWindow& window, const Vec3& pole);

/// Numbers of the poles in the window, in order.
std::vector<std::size_t> picked(const SetWindow& window, std::span<const Vec3> poles);

/// Reads "45/120~15", a cone of 15° about the pole of a plane, or "30..60/100..140", ranges of dip and dip direction.
/// Throws InputError, which names `place`.
SetWindow window_from_text(const std::string& text, const std::string& place);

/// As `window_from_text` reads it.
std::string window_text(const SetWindow& window);

}  // namespace talus
