#include "orientation/drawn_planes.hpp"

#include <cmath>

#include "orientation/joint_network.hpp"
#include "orientation/random_numbers.hpp"

namespace talus {
namespace {

constexpr double usual_variation = 0.5;  // standard deviation over mean, where none is given

double next_spacing(const Cut& cut, RandomNumbers& random) {
  const double mean = cut.spacing.value_or(0), deviation = cut.spacing_deviation.value_or(usual_variation * mean);
  switch (cut.spacing_law) {
    case SpacingLaw::normal:
      return to_millionths(random.positive_normal(mean, deviation));
    case SpacingLaw::exponential:
      return to_millionths(mean * random.exponential());
    case SpacingLaw::lognormal:
      return to_millionths(random.lognormal(mean, deviation));
    case SpacingLaw::equal:
      break;
  }
  return mean;
}

Cut single_plane(const Cut& cut, const PlaneAttitude& attitude, const Vec3& shift) {
  Cut plane;
  plane.joint = cut.joint;
  plane.dip = attitude.dip;
  plane.dip_direction = attitude.dip_direction;
  plane.through = cut.through + shift;
  plane.solids = cut.solids;
  plane.ends_at = cut.ends_at;
  if (cut.disc) plane.disc = {cut.disc->centre + shift, cut.disc->radius};
  for (const Vec3& corner : cut.polygon) plane.polygon.push_back(corner + shift);
  return plane;
}

}  // namespace

double to_millionths(double value) { return std::round(value * 1e6) / 1e6; }

PlaneAttitude drawn_attitude(const Cut& cut, RandomNumbers& random) {
  const PlaneAttitude mean{cut.dip, cut.dip_direction};
  if (!cut.fisher_kappa) return mean;
  const PlaneAttitude drawn = attitude_of_normal(random.fisher(pole_of(mean), *cut.fisher_kappa));
  return upright({to_millionths(drawn.dip), to_millionths(drawn.dip_direction)});
}

bool is_drawn(const Cut& cut) {
  return cut.spacing_law != SpacingLaw::equal || cut.fisher_kappa.has_value() || cut.network.has_value();
}

std::vector<Cut> single_planes(const Cut& cut) {
  if (cut.network) return discs_of_network(cut);
  // Spacings and attitudes have engines of their own: a scatter that is added moves no plane.
  const auto seed = static_cast<std::uint64_t>(cut.seed.value_or(1));
  RandomNumbers spacings(2 * seed), attitudes(2 * seed + 1);
  const Vec3 up = -pole_of({cut.dip, cut.dip_direction});
  std::vector<Cut> planes;
  double offset = 0;
  for (int i = 0; i < cut.count.value_or(1); ++i) {
    if (i > 0) offset += next_spacing(cut, spacings);
    planes.push_back(single_plane(cut, drawn_attitude(cut, attitudes), offset * up));
  }
  return planes;
}

}  // namespace talus
