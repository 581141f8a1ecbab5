#include "verification/known_answers/support/scene.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(Scene, ExpectationsScaleWithTheirQuantity) {
  CaseScene scene;
  for (const char* quantity : {"P.displacement.z", "P.velocity.magnitude", "P.stress.zz"})
    for (const double value : {8.0, 0.0}) {
      Expectation expectation;
      expectation.quantity = quantity;
      expectation.time = 2;
      expectation.value = value;
      expectation.tolerance = 0.5;
      scene.project.expect.push_back(expectation);
    }
  const std::vector<Expectation> expect = scaled(scene, 0.25).project.expect;
  for (const Expectation& expectation : expect) EXPECT_EQ(expectation.time, 1);
  EXPECT_EQ(expect[0].value, 2);
  EXPECT_EQ(expect[2].value, 4);
  EXPECT_EQ(expect[4].value, 2) << "stress goes with ρgh";
  // A tolerance is absolute where the value is zero, and has its unit there.
  EXPECT_EQ(expect[0].tolerance, 0.5);
  EXPECT_EQ(expect[4].tolerance, 0.5);
  EXPECT_EQ(expect[1].tolerance, 0.125);
  EXPECT_EQ(expect[3].tolerance, 0.25);
  EXPECT_EQ(expect[5].tolerance, 0.125);
}

}  // namespace
}  // namespace talus
