#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "unit/contact/blocks.hpp"

namespace {
std::atomic<long> allocations{0};
}

// Every allocation of this program is counted.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"  // GCC 12 takes the pair below for two strangers
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
  double points;  // a step
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
  for (int i = 0; i < steps; ++i) step();
  return {static_cast<double>(points) / steps, allocations - allocated};
}

TEST(Allocation, AStepOfASlopeHardlyAllocates) {
  Scene scene = slope();
  const Measured run = slide(scene, 200);
  EXPECT_GT(run.points, 50);
  EXPECT_LE(run.allocations, 5);  // a buffer may still grow with a new number of corners
}

}  // namespace
}  // namespace talus
