#include "effects/point_load.hpp"

namespace talus {

double PointLoads::energy(const Increment& d) const {
  double sum = 0;
  for (const LoadedPoint& load : loads_)
    for (int i = 0; i < 4; ++i)
      sum -= load.point.weights[i] * load.force.dot(set_.node_increment(load.point.nodes[i], d));
  return sum;
}

void PointLoads::add_gradient(const Increment&, Eigen::VectorXd& sum) const {
  for (const LoadedPoint& load : loads_)
    for (int i = 0; i < 4; ++i) {
      const int freedom = set_.nodes.freedom[load.point.nodes[i]];
      if (freedom >= 0) sum.segment<3>(3 * freedom) -= load.point.weights[i] * load.force;
    }
}

}  // namespace talus
