#include "orientation/critical_zone.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace talus {
namespace {

TEST(CriticalZone, HoldsThePolesThatTheCheckCounts) {
  const KinematicSetting setting{{65.3, 137.1}, 31.7, 20};
  for (double dip = 1; dip < 90; dip += 4)
    for (double direction = 0; direction < 360; direction += 7) {
      const PlaneAttitude plane{dip, direction};
      const PlaneFindings found = kinematic_check(std::vector{plane}, setting).planes.front();
      EXPECT_EQ(critical_margin(pole_of(plane), FailureMode::planar, setting) > 0, found.planar) << plane_text(plane);
      EXPECT_EQ(critical_margin(pole_of(plane), FailureMode::flexural, setting) > 0, found.flexural)
          << plane_text(plane);
    }
}

TEST(CriticalZone, HoldsTheIntersectionsThatTheCheckCounts) {
  const KinematicSetting setting{{65.3, 137.1}, 31.7, 20};
  std::vector<PlaneAttitude> planes;
  for (int i = 0; i < 60; ++i) planes.push_back({10 + (i * 37) % 80 + 0.3, (i * 101) % 360 + 0.7});
  int wedges = 0, topples = 0;
  for (const IntersectionFindings& found : kinematic_check(planes, setting).intersections) {
    const Vec3 line = direction_of(found.line);
    EXPECT_EQ(critical_margin(line, FailureMode::wedge, setting) > 0, found.wedge);
    EXPECT_EQ(critical_margin(line, FailureMode::direct, setting) > 0, found.direct);
    wedges += found.wedge;
    topples += found.direct;
  }
  EXPECT_GT(wedges, 0);
  EXPECT_GT(topples, 0);
}

TEST(CriticalZone, OfFlexuralTopplingIsEmptyInAFlatFace) {
  const KinematicSetting setting{{20, 90}, 30, 20};
  for (double dip = 0; dip <= 90; dip += 5)
    EXPECT_LT(critical_margin(pole_of({dip, 270}), FailureMode::flexural, setting), 0);
}

}  // namespace
}  // namespace talus
