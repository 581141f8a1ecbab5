#include "solve/energy_balance.hpp"

#include "effects/inertia.hpp"

namespace talus {

namespace {

double elastic_energy(const BodySet& set) {
  double sum = 0;
  for (std::size_t e = 0; e < set.elements.size(); ++e)
    sum += set.shapes[e].volume * set.bodies[set.elements[e].body].elastic.energy_density(set.stress[e]);
  return sum;
}

double weight_energy(const BodySet& set, const Vec3& gravity) {
  double sum = 0;
  for (const Element& element : set.elements)
    for (const int node : element.nodes)
      sum -= element.mass / 4 * gravity.dot(set.nodes.position[node] - set.nodes.reference[node]);
  return sum;
}

}  // namespace

EnergyBalance::EnergyBalance(const Project& project, const BlockSystem& system) : gravity_(project.gravity) {
  for (const PointLoad& load : project.loads)
    loads_.emplace_back(material_point(system, load.block, load.at, 1e300, "/loads"), load.force);
}

EnergyLedger EnergyBalance::after_step(const BodySet& set, const ContactSet& contacts,
                                       const std::vector<ContactForces>& forces) {
  EnergyLedger ledger;
  ledger.kinetic = Inertia::kinetic_energy(set);
  ledger.elastic = elastic_energy(set);
  ledger.potential = weight_energy(set, gravity_);
  for (const auto& [point, force] : loads_)
    ledger.potential -= force.dot(point.at(set.nodes.position) - point.at(set.nodes.reference));
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    ledger.contact += forces[i].normal * forces[i].normal / (2 * point.normal_stiffness) +
                      forces[i].shear.squaredNorm() / (2 * point.shear_stiffness);
    friction_ += forces[i].shear.norm() * forces[i].slip;
  }
  ledger.friction_dissipated = friction_;
  ledger.integration_loss =
      given_ - (ledger.kinetic + ledger.elastic + ledger.potential + ledger.contact + ledger.friction_dissipated);
  return ledger;
}

}  // namespace talus
