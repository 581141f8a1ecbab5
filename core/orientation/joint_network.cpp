#include "orientation/joint_network.hpp"

#include <cmath>
#include <numbers>

#include "model/rock/joint_network.hpp"
#include "orientation/drawn_planes.hpp"
#include "orientation/random_numbers.hpp"

namespace talus {
namespace {

double next_radius(const JointNetwork& network, RandomNumbers& random) {
  switch (network.radius_law) {
    case RadiusLaw::exponential:
      return to_millionths(network.radius * random.exponential());
    case RadiusLaw::lognormal:
      return to_millionths(random.lognormal(network.radius, radius_deviation(network)));
    case RadiusLaw::equal:
      break;
  }
  return network.radius;
}

Vec3 next_centre(const BoxShape& box, RandomNumbers& random) {
  Vec3 centre;
  for (Eigen::Index i = 0; i < 3; ++i)
    centre[i] = to_millionths(box.min[i] + random.uniform() * (box.max[i] - box.min[i]));
  return centre;
}

}  // namespace

std::vector<Cut> discs_of_network(const Cut& cut) {
  const JointNetwork& network = *cut.network;
  const auto seed = static_cast<std::uint64_t>(cut.seed.value_or(1));
  // Engines of their own, as with planes: a scatter that is added moves no disc.
  RandomNumbers attitudes(2 * seed + 1), centres(2 * seed), radii(~seed);
  const double wanted = network.density * (network.box.max - network.box.min).prod();
  std::vector<Cut> discs;
  for (double area = 0; area < wanted;) {
    const PlaneAttitude attitude = drawn_attitude(cut, attitudes);
    Cut disc;
    disc.joint = cut.joint;
    disc.dip = attitude.dip;
    disc.dip_direction = attitude.dip_direction;
    disc.through = next_centre(network.box, centres);
    disc.disc = {disc.through, next_radius(network, radii)};
    disc.solids = cut.solids;
    disc.ends_at = cut.ends_at;
    area += std::numbers::pi * disc.disc->radius * disc.disc->radius;
    discs.push_back(disc);
  }
  return discs;
}

}  // namespace talus
