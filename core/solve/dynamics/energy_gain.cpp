#include "solve/dynamics/energy_gain.hpp"

#include "bodies/consistent_mass.hpp"
#include "effects/inertia.hpp"

namespace talus {

void EnergyGain::note_start() {
  position_ = set_.nodes.position;
  velocity_ = set_.nodes.velocity;
  kinetic_.clear();
  for (int b = 0; b < static_cast<int>(set_.bodies.size()); ++b)
    kinetic_.push_back(Inertia::kinetic_energy(set_, std::span(&b, 1)));
}

void EnergyGain::note_without_contact(std::span<const int> bodies, double length) {
  asked_of_ = bodies;
  given_ = 0;
  for (const int b : bodies) {
    const Body& body = set_.bodies[b];
    if (body.fixed) continue;
    double work = 0;  // J s, of other forces
    if (body.kind == BodyKind::rigid) work += work_on(set_.rigid[body.rigid]);
    for (int e = body.first_element; e < body.first_element + body.element_count; ++e)
      work += work_on(set_.elements[e]);
    given_ += kinetic_[b] + work / length;
  }
}

double EnergyGain::work_on(const RigidBody& body) const {
  return body.mass * change_of_velocity(body.centre).dot(way(body.centre));
}

double EnergyGain::work_on(const Element& element) const {
  Corners velocities, ways;
  for (int i = 0; i < 4; ++i) {
    velocities[i] = change_of_velocity(element.nodes[i]);
    ways[i] = way(element.nodes[i]);
  }
  return mass_product(element.mass, velocities, ways);
}

double EnergyGain::kinetic() const { return Inertia::kinetic_energy(set_, asked_of_); }

double EnergyGain::gain() const { return kinetic() - given_; }

}  // namespace talus
