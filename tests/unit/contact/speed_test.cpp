#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <new>

#include "blocks.hpp"

namespace {
std::atomic<long> allocations{0};
}

// Every allocation of this program is counted.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace talus {
namespace {

using testing::box;
using testing::Scene;

/// A slope of Jiweishan's kind: fixed ground of 176 triangles and a side wall, a slab of 68 on it, a key block of 12
/// before it.
Scene slope() {
  Scene scene;
  scene.young = 25e9;
  scene.add(box({-100, -400, -100}, {200, 400, 0}, {4, 8, 1}), true);
  scene.add(box({-100, -400, 0}, {0, 0, 80}, {1, 2, 1}), true);
  scene.add(box({0, -350, 0}, {130, -20, 64}, {2, 5, 1}, true));
  scene.add(box({0, -20, 0}, {130, 220, 64}, {1, 1, 1}, true));
  return scene;
}

struct Measured {
  double milliseconds;  // of processor time a step: the machine may be busy
  double points;
  long allocations;
};

Measured slide(Scene& scene, int steps) {
  std::vector<ContactOutcome> outcomes(2000);
  std::size_t points = 0;
  const auto step = [&] {
    scene.move(2, {0, 0.05, 0});
    scene.move(3, {0, 0.06, 0});
    const std::size_t count = scene.detect(1.0).points.size();
    points += count;
    scene.detector().accept(scene.contacts, std::span(outcomes).first(count));
  };
  for (int i = 0; i < 60; ++i) step();  // buffers find their size
  points = 0;
  const long allocated = allocations;
  const std::clock_t begin = std::clock();
  for (int i = 0; i < steps; ++i) step();
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return {1e3 * seconds / steps, static_cast<double>(points) / steps, allocations - allocated};
}

TEST(Speed, AStepOfASlopeTakesWellUnderAMillisecondAndHardlyAllocates) {
  Scene scene = slope();
  const Measured run = slide(scene, 200);
  std::cout << run.milliseconds << " ms a step, " << run.points << " points\n";
  EXPECT_GT(run.points, 50);
  EXPECT_LE(run.allocations, 5);  // a buffer may still grow with a new number of corners
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(run.milliseconds, 1.5);  // 0.3 on an idle machine
#endif
}

}  // namespace
}  // namespace talus
