#include "bodies/consistent_mass.hpp"

namespace talus {

double mass_product(double mass, const Corners& u, const Corners& w) {
  double sum = (u[0] + u[1] + u[2] + u[3]).dot(w[0] + w[1] + w[2] + w[3]);
  for (int corner = 0; corner < 4; ++corner) sum += u[corner].dot(w[corner]);
  return mass / 20 * sum;
}

void add_mass_times(const Element& element, double scale, const Corners& u, Eigen::VectorXd& sum) {
  const Vec3 total = u[0] + u[1] + u[2] + u[3];
  for (int a = 0; a < 4; ++a) sum.segment<3>(3 * element.dof_blocks[a]) += scale * (total + u[a]);
}

void add_mass(const Element& element, double scale, SymmetricBlocks& sum) {
  const Mat3 block = scale * Mat3::Identity();
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b <= a; ++b) sum.add(element.dof_blocks[a], element.dof_blocks[b], a == b ? 2 * block : block);
}

}  // namespace talus
