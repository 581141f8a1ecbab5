#include "base/rotation.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

TEST(RotationOnto, TakesOneDirectionOntoTheOtherWhateverTheirLengths) {
  const Vec3 from(1, 1, 1), to(0, 0, 3);
  const Mat3 turn = rotation_onto(from, to);
  EXPECT_LT((turn * from.normalized() - Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((turn * turn.transpose() - Mat3::Identity()).norm(), 1e-15);
  EXPECT_NEAR(turn.determinant(), 1, 1e-15);
}

TEST(RotationOnto, IsTheSmallest) {
  Mat3 quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_LT((rotation_onto(Vec3::UnitX(), 2 * Vec3::UnitY()) - quarter).norm(), 1e-15);
  EXPECT_LT((rotation_onto(Vec3(1, 2, 3), Vec3(1, 2, 3)) - Mat3::Identity()).norm(), 1e-15);
}

}  // namespace
}  // namespace talus
