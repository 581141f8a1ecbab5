#include "verification/known_answers/blocks/dominoes.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(Dominoes, ALongRowFallsAtItsOwnSpeedWhateverThePush) {
  EXPECT_NEAR((DominoRow{0.15, 0.3}.front_speeds(0.7, 40).back()), 1.840, 5e-4);
  EXPECT_NEAR((DominoRow{0.15, 0.3}.front_speeds(1.5, 40).back()), 1.840, 5e-4);
  EXPECT_NEAR((DominoRow{0.15, 0.5}.front_speeds(1.0, 40).back()), 1.698, 5e-4);
}

}  // namespace
}  // namespace talus
