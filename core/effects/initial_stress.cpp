#include "effects/initial_stress.hpp"

namespace talus {

double InitialStress::energy(const Increment& d) const {
  double sum = 0;
  for (std::size_t e = 0; e < set_.elements.size(); ++e)
    sum +=
        set_.shapes[e].volume * strain(set_.shapes[e], set_.corner_increments(set_.elements[e], d)).dot(set_.stress[e]);
  return sum;
}

void InitialStress::add_gradient(const Increment&, Arms, Eigen::VectorXd& sum) const {
  for (std::size_t e = 0; e < set_.elements.size(); ++e)
    for (int a = 0; a < 4; ++a)
      sum.segment<3>(3 * set_.elements[e].dof_blocks[a]) += corner_force(set_.shapes[e], set_.stress[e], a);
}

}  // namespace talus
