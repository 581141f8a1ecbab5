#pragma once

#include <string_view>

#include "orientation/kinematics.hpp"

namespace talus {

/// The ways of failing whose zone on the net can be shown; planes are judged by their poles, pairs by their lines of
/// intersection.
enum class FailureMode { planar, wedge, flexural, direct };

constexpr std::string_view to_string(FailureMode mode) {
  switch (mode) {
    case FailureMode::planar:
      return "planar sliding";
    case FailureMode::wedge:
      return "wedge sliding";
    case FailureMode::flexural:
      return "flexural toppling";
    case FailureMode::direct:
      break;
  }
  return "direct toppling";
}

/// Whether the zone is one of lines of intersection rather than of poles.
constexpr bool judges_lines(FailureMode mode) { return mode == FailureMode::wedge || mode == FailureMode::direct; }

/// How far a place of the net is inside the zone that `kinematic_check` counts: positive inside, zero on its border,
/// negative outside. It has no unit, and goes on smoothly above the horizon, so that the border can be contoured.
/// `line`: a downward pole or line.
double critical_margin(const Vec3& line, FailureMode mode, const KinematicSetting& setting);

}  // namespace talus
