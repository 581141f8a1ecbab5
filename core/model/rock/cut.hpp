#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"
#include "model/rock/solid.hpp"

/// The joints that divide the solids: planes without end, sets of them, and joints that end.
namespace talus {

/// How the distances of a set's planes vary about their mean.
enum class SpacingLaw { equal, normal, exponential, lognormal };

/// The word the project file uses.
constexpr std::string_view to_string(SpacingLaw law) {
  switch (law) {
    case SpacingLaw::normal:
      return "normal";
    case SpacingLaw::exponential:
      return "exponential";
    case SpacingLaw::lognormal:
      return "lognormal";
    case SpacingLaw::equal:
      break;
  }
  return "equal";
}

/// A joint that ends at a circle.
struct Disc {
  Vec3 centre = Vec3::Zero();  ///< m
  double radius = 0;           ///< m
  bool operator==(const Disc&) const = default;
};

/// How the radii of a network's discs vary about their mean.
enum class RadiusLaw { equal, exponential, lognormal };

/// The word the project file uses.
constexpr std::string_view to_string(RadiusLaw law) {
  switch (law) {
    case RadiusLaw::exponential:
      return "exponential";
    case RadiusLaw::lognormal:
      return "lognormal";
    case RadiusLaw::equal:
      break;
  }
  return "equal";
}

/// A discrete fracture network: discs with centres by chance in a box, until their area is `density` times its volume
/// (P32; Dershowitz & Herda 1992).
struct JointNetwork {
  BoxShape box;
  double density = 0;  ///< m²/m³
  double radius = 0;   ///< m, mean
  RadiusLaw radius_law = RadiusLaw::equal;
  std::optional<double> radius_deviation{};  ///< m, of a lognormal radius; half the mean when absent
  bool operator==(const JointNetwork&) const = default;
};

/// A plane through `through`, or `count` ones `spacing` apart along the upward normal: parallel and equally far, or
/// drawn by a law of spacing and a scatter about the mean attitude (orientation/drawn_planes). At most one of disc,
/// polygon and network makes them end; `through` is then the disc's centre, the mean of the polygon's points, or the
/// middle of the network's box.
struct Cut {
  std::string joint;
  double dip = 0, dip_direction = 0;  ///< degrees
  Vec3 through = Vec3::Zero();        ///< m
  std::optional<double> spacing;      ///< m
  std::optional<int> count;
  std::vector<std::string> solids;  ///< names it is limited to; all when empty
  SpacingLaw spacing_law = SpacingLaw::equal;
  std::optional<double> spacing_deviation{};  ///< m, of a normal or lognormal spacing; half the spacing when absent
  std::optional<double> fisher_kappa{};       ///< scatter of the poles (Fisher 1953); absent: all are parallel
  std::optional<int> seed{};                  ///< of what is drawn; 1 when absent
  std::optional<Disc> disc{};
  std::vector<Vec3> polygon{};  ///< m, corners in order, put onto the plane along its normal; none: no polygon
  std::optional<JointNetwork> network{};
  std::vector<std::string> ends_at{};  ///< names of joints: it ends where it meets their cuts, on the side of `through`
  bool operator==(const Cut&) const = default;
};

}  // namespace talus
