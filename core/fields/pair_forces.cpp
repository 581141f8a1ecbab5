#include "fields/pair_forces.hpp"

#include <map>
#include <utility>

namespace talus {

std::vector<PairForce> pair_forces(const Frame& frame, std::span<const Vec3> places) {
  struct Sum {
    Vec3 moment = Vec3::Zero(), force = Vec3::Zero();  // N m, N
    double normal = 0;                                 // N
  };
  std::map<std::array<int, 2>, Sum> sums;
  for (std::size_t i = 0; i < frame.contacts.size(); ++i) {
    const ContactSample& contact = frame.contacts[i];
    if (!(contact.normal_force > 0)) continue;
    Sum& sum = sums[{contact.blocks[0], contact.blocks[1]}];
    sum.moment += contact.normal_force * places[i];
    sum.force += contact.normal_force * contact.normal + contact.shear_force;
    sum.normal += contact.normal_force;
  }
  std::vector<PairForce> forces;
  for (const auto& [blocks, sum] : sums) forces.push_back({blocks, sum.moment / sum.normal, sum.force});
  return forces;
}

}  // namespace talus
