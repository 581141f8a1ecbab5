#include "study/accuracy/perturbation.hpp"

#include "orientation/random_numbers.hpp"

namespace talus {

namespace {

class Perturbation {
 public:
  explicit Perturbation(int repeat) : numbers_(static_cast<std::uint64_t>(repeat)) {}

  void change(Vec3& vector) {
    const double length = vector.norm();
    for (double& component : vector) component += length * share();
  }
  double share() { return perturbation_share * (2 * numbers_.uniform() - 1); }

 private:
  RandomNumbers numbers_;
};

void scale(std::vector<PointLoad>& loads, double factor) {
  for (PointLoad& load : loads) {
    load.force *= factor;
    for (TableRow& row : load.table) row.value *= factor;
  }
}

}  // namespace

Project perturbed(Project project, int repeat) {
  if (repeat == 0) return project;
  Perturbation chance(repeat);
  chance.change(project.gravity);
  for (InitialVelocity& velocity : project.velocities) {
    chance.change(velocity.linear);
    chance.change(velocity.angular);
  }
  const double factor = 1 + chance.share();  // one for all: loads that balance each other go on doing so
  scale(project.loads, factor);
  for (Stage& stage : project.stages)
    if (stage.loads) scale(*stage.loads, factor);
  return project;
}

}  // namespace talus
