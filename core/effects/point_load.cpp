#include "effects/point_load.hpp"

#include "model/time_table.hpp"

namespace talus {

void PointLoads::begin_step(const StepContext& step) {
  const double time = step.time + step.integration.smooth_fraction() * step.length;
  moves_.clear();
  for (LoadedPoint& load : loads_) {
    if (!load.table.empty()) load.force = value_at(load.table, time);
    moves_.add(load.point.nodes, load.point.weights);
  }
}

double PointLoads::energy(const Increment& d) const {
  double sum = 0;
  for (int i = 0; i < moves_.size(); ++i) sum -= loads_[i].force.dot(moves_.increment(i, d));
  return sum;
}

void PointLoads::add_gradient(const Increment& d, Arms arms, Eigen::VectorXd& sum) const {
  for (int i = 0; i < moves_.size(); ++i) moves_.add_force(i, d, -loads_[i].force, arms, sum);
}

void PointLoads::add_unsymmetric(const Increment& d, Arms arms, UnsymmetricBlocks& sum) const {
  for (int i = 0; i < moves_.size(); ++i) moves_.add_turning(i, d, -loads_[i].force, arms, sum);
}

}  // namespace talus
