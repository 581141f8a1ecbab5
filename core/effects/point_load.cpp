#include "effects/point_load.hpp"

#include "model/time_table.hpp"

namespace talus {

void PointLoads::begin_step(const StepContext& step) {
  const double time = step.time + step.integration.smooth_share() * step.length;
  for (LoadedPoint& load : loads_)
    if (!load.table.empty()) load.force = value_at(load.table, time);
}

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
