#include "model/rock/joint_network.hpp"

#include <numbers>

namespace talus {
namespace {

/// m², mean of the square of the radius.
double mean_square(const JointNetwork& network) {
  const double square = network.radius * network.radius, deviation = radius_deviation(network);
  switch (network.radius_law) {
    case RadiusLaw::exponential:
      return 2 * square;
    case RadiusLaw::lognormal:
      return square + deviation * deviation;
    case RadiusLaw::equal:
      break;
  }
  return square;
}

}  // namespace

double radius_deviation(const JointNetwork& network) { return network.radius_deviation.value_or(network.radius / 2); }

double expected_discs(const JointNetwork& network) {
  const double volume = (network.box.max - network.box.min).prod();
  return network.density * volume / (std::numbers::pi * mean_square(network));
}

}  // namespace talus
