#include "contact/contact_point.hpp"

#include <gtest/gtest.h>

#include "blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::Scene;

ContactPoint point(double friction, bool bonded, double cohesion) {
  ContactPoint p;
  p.friction = friction;
  p.bonded = bonded;
  p.cohesion = cohesion;
  return p;
}

TEST(ContactSet, SortsPointsByWhatTheirLawCallsFor) {
  ContactSet set;
  set.points = {point(0, false, 0), point(0.5, false, 0), point(0, true, 0), point(0, true, 7), point(0.5, true, 7)};
  for (int again = 0; again < 2; ++again) {
    set.sort_out();
    EXPECT_EQ(set.loose, (std::vector{0, 1}));
    EXPECT_EQ(set.bonded, (std::vector{2, 3, 4}));
    EXPECT_EQ(set.sheared, (std::vector{1, 3, 4}));
  }
  set.clear();
  EXPECT_TRUE(set.points.empty() && set.loose.empty() && set.bonded.empty() && set.sheared.empty());
}

TEST(ContactSet, IsHandedOutSorted) {
  Scene scene;
  scene.laws = {{.friction = 0}};
  scene.add(box({0, 0, -1}, {3, 3, 0}), true);
  scene.add(box({1, 1, 0}, {2, 2, 1}));
  const std::size_t count = scene.detect(0.01).points.size();
  EXPECT_GT(count, 0u);
  EXPECT_EQ(scene.contacts.loose.size(), count);
  EXPECT_TRUE(scene.contacts.sheared.empty());
  scene.detector().set_laws({{.friction = 0, .cohesion = 1e5}});
  scene.detect(0.01);
  EXPECT_TRUE(scene.contacts.loose.empty());
  EXPECT_EQ(scene.contacts.bonded.size(), count);
  EXPECT_EQ(scene.contacts.sheared.size(), count);
}

}  // namespace
}  // namespace talus
