#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/accuracy/setting.hpp"

namespace talus {

/// What an accuracy study varies.
enum class StudyAxis {
  body,
  strain,
  integrator,
  time_step,
  static_step,
  mesh_size,
  contact,
  contact_stiffness,
  penetration_tolerance,
  tolerance,
  scheme
};

constexpr std::string_view to_string(StudyAxis axis) {
  constexpr std::string_view words[] = {"body",
                                        "strain",
                                        "integrator",
                                        "time_step",
                                        "static_step",
                                        "mesh_size",
                                        "contact",
                                        "contact_stiffness",
                                        "penetration_tolerance",
                                        "tolerance",
                                        "scheme"};
  return words[static_cast<int>(axis)];
}

/// Axes whose values have a size. Errors have an order along time step, mesh size and the softness of contacts, one
/// over their stiffness: springs give way by force over stiffness. A static step has a size and no
/// order: it is a path to rest, and a shorter one is another path, neither nearer to rest nor further from it.
inline constexpr StudyAxis sized_axes[] = {StudyAxis::time_step, StudyAxis::static_step, StudyAxis::mesh_size,
                                           StudyAxis::contact_stiffness};
/// Of such an axis: a factor of the project's own; of contacts that of their softness.
double size_on(StudyAxis axis, const Setting& setting);
/// The project's own size on it.
void set_own_size(StudyAxis axis, Setting& setting);

/// Which axes, and which values of each, as the user writes them: bodies, strains, integrators and schemes by the words
/// of the project file, factors as numbers, tolerances as numbers or "off".
struct LadderWish {
  std::vector<StudyAxis> axes;  ///< all where empty
  std::map<StudyAxis, std::vector<std::string>> values{};
};

/// From "body,time_step" and "time_step=4,2,1"; an axis whose values are given is one that is asked for.
/// Throws InputError.
LadderWish parse_ladder_wish(const std::vector<std::string>& axes, const std::vector<std::string>& values);

/// A setting, or a whole axis, that was not taken, and why.
struct LeftOut {
  std::string what, reason;
};

struct Ladder {
  std::vector<Setting> settings;  ///< each once; the first is the project's own
  int finest = 0;                 ///< into settings: what others are held to where no answer is known
  std::vector<LeftOut> left_out;
};

/// The star about the project's own setting, each axis alone, and a few that differ on several: coarse and cheap ones,
/// coarse on one axis and fine on another, and the finest. What the project's rules refuse, or what cannot change its
/// answer, is left out. Throws InputError for a value that an axis does not have.
Ladder make_ladder(const Project& project, const LadderWish& wish);

/// About how much a setting costs beside others: for the order of runs and the time that is left, no more.
double relative_cost(const Setting& setting);

}  // namespace talus
