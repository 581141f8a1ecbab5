#include "solve/dynamics/rigid_energy.hpp"

#include "effects/rigid_inertia.hpp"

namespace talus {

void RigidEnergy::note_start() {
  starts_.clear();
  for (const RigidBody& body : set_.rigid)
    starts_.push_back({set_.nodes.position[body.centre], set_.nodes.velocity[body.centre], kinetic_energy(set_, body)});
}

void RigidEnergy::note_without_contact(std::span<const int> bodies, double length) {
  asked_of_.clear();
  given_ = 0;
  for (const int b : bodies) {
    if (set_.bodies[b].fixed || set_.bodies[b].kind != BodyKind::rigid) continue;
    const int number = set_.bodies[b].rigid;
    const RigidBody& body = set_.rigid[number];
    const Start& start = starts_[number];
    const Vec3 by_loads = body.mass * (set_.nodes.velocity[body.centre] - start.velocity);  // N s
    given_ += start.kinetic + by_loads.dot(set_.nodes.position[body.centre] - start.position) / length;
    asked_of_.push_back(number);
  }
}

double RigidEnergy::kinetic() const {
  double sum = 0;
  for (const int number : asked_of_) sum += kinetic_energy(set_, set_.rigid[number]);
  return sum;
}

double RigidEnergy::gain() const { return kinetic() - given_; }

}  // namespace talus
