#include "render/stereonet/slope_key.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

std::vector<std::string> words(FailureMode mode) {
  Stereonet net;
  net.slope = KinematicSetting{{65, 140}, 30, 20};
  net.mode = mode;
  std::vector<std::string> all;
  for (const SlopeKeyRow& row : slope_key(net)) all.push_back(row.words);
  return all;
}

TEST(SlopeKey, SaysWhatEveryModeDraws) {
  using testing::Contains;
  using testing::Not;
  for (const FailureMode mode : {FailureMode::planar, FailureMode::wedge, FailureMode::flexural, FailureMode::direct})
    EXPECT_THAT(words(mode), Contains("face"));
  EXPECT_THAT(words(FailureMode::planar), Contains("daylight envelope of its poles"));
  EXPECT_THAT(words(FailureMode::wedge), Contains("friction cone φ"));
  EXPECT_THAT(words(FailureMode::wedge), Not(Contains("lateral limits")));
  EXPECT_THAT(words(FailureMode::flexural), Contains("slip limit, face dip − φ"));
  EXPECT_THAT(words(FailureMode::direct), Contains("critical intersections"));
}

TEST(SlopeKey, IsEmptyWithoutASlope) { EXPECT_TRUE(slope_key(Stereonet{}).empty()); }

}  // namespace
}  // namespace talus
