#include "model/rules/cut_rules.hpp"

#include <cmath>

#include "model/number_text.hpp"
#include "model/require.hpp"
#include "model/rock/joint_network.hpp"
#include "model/rules/solid_rules.hpp"

namespace talus {
namespace {

/// What chance decides of a set of joints.
void check_drawing(const Cut& cut, const Place& place) {
  const SpacingLaw law = cut.spacing_law;
  const std::string name(to_string(law));
  const bool has_law = law != SpacingLaw::equal;
  require(!has_law || cut.spacing, place / "spacing_law", "a law of spacing needs a spacing, its mean",
          "add 'spacing' in m and 'count'");
  require(!cut.spacing_deviation || law == SpacingLaw::normal || law == SpacingLaw::lognormal,
          place / "spacing_deviation", "the law " + name + " has no standard deviation to give",
          "leave it out, or take the law normal or lognormal");
  if (cut.spacing_deviation)
    require_positive(*cut.spacing_deviation, place / "spacing_deviation", "standard deviation", "m");
  if (cut.fisher_kappa)
    require(*cut.fisher_kappa > 0 && std::isfinite(*cut.fisher_kappa), place / "fisher_kappa",
            "Fisher's κ must be greater than 0, is " + number_text(*cut.fisher_kappa),
            "give a positive number: 20 scatters much, 500 little");
  require(!cut.seed || has_law || cut.fisher_kappa || cut.network, place / "seed", "there is nothing to draw",
          "add 'spacing_law', 'fisher_kappa' or a network, or leave the seed out");
  require(cut.seed.value_or(1) >= 0, place / "seed", "a seed is not negative", "give 0, 1, 2 …");
}

void check_network(const JointNetwork& network, const Place& place) {
  check(network.box, place / "box");
  require_positive(network.density, place / "density", "density", "m² of joint per m³ of rock");
  require_positive(network.radius, place / "radius", "radius", "m");
  require(!network.radius_deviation || network.radius_law == RadiusLaw::lognormal, place / "radius_deviation",
          "the law " + std::string(to_string(network.radius_law)) + " has no standard deviation to give",
          "leave it out, or take the law lognormal");
  if (network.radius_deviation)
    require_positive(*network.radius_deviation, place / "radius_deviation", "standard deviation", "m");
  constexpr double most = 20000;
  const double discs = expected_discs(network);
  require(!(discs > most), place / "density",
          "the network would have about " + significant(discs) + " discs, more than " + number_text(most),
          "lower the density, raise the radius, or make the box smaller");
}

/// What makes a joint end.
void check_ends(const Cut& cut, const Place& place) {
  const int kinds = (cut.disc ? 1 : 0) + (cut.polygon.empty() ? 0 : 1) + (cut.network ? 1 : 0);
  require(kinds <= 1, place, "a cut is a disc, a polygon or a network, not several of them",
          "make them cuts of their own");
  if (cut.disc) {
    require_finite(cut.disc->centre, place / "disc" / "centre");
    require_positive(cut.disc->radius, place / "disc" / "radius", "radius", "m");
  }
  require(cut.polygon.empty() || cut.polygon.size() >= 3, place / "polygon", "a polygon has at least three corners",
          "add corners, or give a plane 'through' a point");
  for (std::size_t i = 0; i < cut.polygon.size(); ++i) require_finite(cut.polygon[i], place / "polygon" / i);
  if (cut.network) check_network(*cut.network, place / "network");
  require(!cut.network || !cut.spacing, place / "spacing", "a network has no spacing",
          "its density says how many there are");
}

}  // namespace

void check(const Cut& cut, const Place& place) {
  require_finite(cut.dip, place / "dip");
  require(cut.dip >= 0 && cut.dip <= 90, place / "dip", "dip must be 0 to 90, is " + number_text(cut.dip),
          "measure it in degrees from the horizontal, and turn dip_direction by 180 for the other side");
  require_finite(cut.dip_direction, place / "dip_direction");
  require(cut.dip_direction >= 0 && cut.dip_direction <= 360, place / "dip_direction",
          "dip direction must be 0 to 360, is " + number_text(cut.dip_direction),
          "measure it in degrees clockwise from north (+y)");
  require_finite(cut.through, place / "through");
  require(cut.spacing.has_value() == cut.count.has_value(), place, "spacing and count belong together",
          cut.spacing ? "add 'count', the number of parallel planes" : "add 'spacing' in m");
  if (cut.spacing) require_positive(*cut.spacing, place / "spacing", "spacing", "m");
  if (cut.count) {
    require(*cut.count >= 1, place / "count", "count must be at least 1, is " + std::to_string(*cut.count),
            "give the number of parallel planes");
  }
  check_ends(cut, place);
  check_drawing(cut, place);
}

}  // namespace talus
