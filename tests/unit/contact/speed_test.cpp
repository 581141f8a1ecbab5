#include <gtest/gtest.h>

#include <ctime>
#include <iostream>

#include "blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::Scene;
using testing::Shape;

/// A slope like Jiweishan's: fixed ground of 152 triangles, a slab of 60 on it, a key block of 12 before the slab, and
/// a side wall.
Scene slope() {
  Scene scene;
  scene.young = 25e9;
  scene.add(box({-100, -400, -100}, {200, 400, 0}, {4, 8, 1}), true);
  scene.add(box({-100, -400, 0}, {0, 0, 80}, {1, 2, 1}), true);
  scene.add(box({0, -350, 0}, {130, -20, 64}, {2, 5, 1}, true));
  scene.add(box({0, -20, 0}, {130, 220, 64}, {1, 1, 1}, true));
  return scene;
}

TEST(Speed, AStepOfASlopeTakesWellUnderHalfAMillisecond) {
  Scene scene = slope();
  const int steps = 500;
  std::size_t points = 0;
  scene.detect(1.0);
  const std::clock_t begin = std::clock();  // of this process: the machine may be busy
  for (int i = 0; i < steps; ++i) {
    scene.move(2, {0, 0.05, 0});
    scene.move(3, {0, 0.06, 0});
    scene.detect(1.0);
    points += scene.contacts.points.size();
    std::vector<ContactOutcome> outcomes(scene.contacts.points.size());
    for (std::size_t k = 0; k < outcomes.size(); ++k) outcomes[k] = {1, Vec3(1, 0, 0), 0, 0, false};
    scene.detector().accept(scene.contacts, outcomes);
  }
  const double ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / steps;
  std::cout << "ms " << ms << " points " << double(points) / steps << " gen " << scene.detector().coupling_generation()
            << " pairs " << scene.detector().coupled_nodes().size() << "\n";
}

}  // namespace
}  // namespace talus
