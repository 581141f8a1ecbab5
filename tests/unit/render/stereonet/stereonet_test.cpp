#include "render/stereonet/stereonet.hpp"

#include <gtest/gtest.h>

#include "render/stereonet/net_shapes.hpp"

namespace talus {
namespace {

/// How far from the net's middle anything of it is filled, in radii, along x or y.
double farthest_fill(const DrawnNet& drawn) {
  double farthest = 0;
  for (const NetShape& shape : drawn.shapes)
    if (const auto* fill = std::get_if<NetFill>(&shape))
      for (const Vec2& corner : fill->corners) farthest = std::max(farthest, corner.cwiseAbs().maxCoeff());
  return farthest;
}

TEST(Stereonet, CoversNothingThatStandsBesideItsLetters) {
  constexpr double letters = 1.085;  // where azimuths stand
  EXPECT_LT(farthest_fill(draw_net({})), letters);
  EXPECT_GT(farthest_fill(draw_net({})), 1) << "what lies beyond the rim of a density is covered";
}

}  // namespace
}  // namespace talus
