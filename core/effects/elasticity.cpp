#include "effects/elasticity.hpp"

namespace talus {

Voigt Elasticity::new_stress(std::size_t e, const Increment& d) const {
  const Element& element = set_.elements[e];
  return set_.bodies[element.body].elastic.stress(strain(set_.shapes[e], set_.corner_increments(element, d)));
}

void Elasticity::add_couplings(std::vector<std::pair<int, int>>& couplings) const { set_.add_couplings(couplings); }

double Elasticity::energy(const Increment& d) const {
  double sum = 0;
  for (std::size_t e = 0; e < set_.elements.size(); ++e)
    sum += 0.5 * set_.shapes[e].volume *
           strain(set_.shapes[e], set_.corner_increments(set_.elements[e], d)).dot(new_stress(e, d));
  return sum;
}

void Elasticity::add_gradient(const Increment& d, Arms, Eigen::VectorXd& sum) const {
  for (std::size_t e = 0; e < set_.elements.size(); ++e) {
    const Voigt stress = new_stress(e, d);
    for (int a = 0; a < 4; ++a)
      sum.segment<3>(3 * set_.elements[e].dof_blocks[a]) += corner_force(set_.shapes[e], stress, a);
  }
}

void Elasticity::add_hessian(const Increment&, SymmetricBlocks& sum) const {
  for (std::size_t e = 0; e < set_.elements.size(); ++e) {
    const Element& element = set_.elements[e];
    const Elastic& elastic = set_.bodies[element.body].elastic;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b)
        sum.add(element.dof_blocks[a], element.dof_blocks[b], stiffness_block(set_.shapes[e], elastic, a, b));
  }
}

void Elasticity::accept(const Increment& d) {
  for (std::size_t e = 0; e < set_.elements.size(); ++e) set_.stress[e] += new_stress(e, d);
}

double Elasticity::stored_energy() const {
  double sum = 0;
  for (std::size_t e = 0; e < set_.elements.size(); ++e)
    sum += set_.shapes[e].volume * set_.bodies[set_.elements[e].body].elastic.energy_density(set_.stress[e]);
  return sum;
}

void Elasticity::add_stress(std::vector<Voigt>& stress) const {
  for (std::size_t e = 0; e < stress.size(); ++e) stress[e] += set_.stress[e];
}

}  // namespace talus
