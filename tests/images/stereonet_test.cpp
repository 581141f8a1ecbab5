#include <gtest/gtest.h>

#include <cmath>

#include "images/baseline.hpp"
#include "images/compare.hpp"
#include "render/stereonet/stereonet_picture.hpp"

namespace talus {
namespace {

/// A set of `count` poles on a spiral about its mean, closer together in the middle.
void add_set(std::vector<MeasuredJoint>& joints, const std::string& name, const PlaneAttitude& mean, int count,
             double widest) {
  for (int i = 0; i < count; ++i) {
    const double reach = widest * (i + 0.5) / count, turn = radians(137.5 * i);
    const double across = std::max(0.2, std::sin(radians(mean.dip)));
    joints.push_back(
        {upright({mean.dip + reach * std::cos(turn), mean.dip_direction + reach * std::sin(turn) / across}), name});
  }
}

/// Bedding that dips out of the slope, a steep set across the horizon, one into the slope, and strays.
std::vector<MeasuredJoint> survey() {
  std::vector<MeasuredJoint> joints;
  add_set(joints, "bedding", {42, 140}, 40, 14);
  add_set(joints, "J1", {86, 50}, 30, 16);
  add_set(joints, "J2", {74, 318}, 24, 12);
  add_set(joints, "random", {45, 250}, 10, 60);
  return joints;
}

TEST(StereonetImage, FisherDensityWithDaylightEnvelope) {
  Stereonet net;
  net.joints = survey();
  net.density = DensityMethod::fisher;
  net.slope = {{65, 140}, 30, 20};
  const Image image = draw_stereonet(net, "Bench 3, face 65/140", 1200, 800);
  for (std::size_t set = 0; set < 4; ++set) EXPECT_GT(count_of(image, set_colour(set, Theme::light)), 100) << set;
  expect_baseline(image);
}

TEST(StereonetImage, DarkKambWithWedgesOnWulffsNet) {
  Stereonet net;
  net.joints = survey();
  net.density = DensityMethod::kamb;
  net.projection = Projection::equal_angle;
  net.slope = {{70, 95}, 30, 20};
  net.mode = FailureMode::wedge;
  net.theme = Theme::dark;
  expect_baseline(draw_stereonet(net, "Wedges in 70/95", 1200, 800));
}

TEST(StereonetImage, FlexuralTopplingWithAWindowAcrossTheRim) {
  Stereonet net;
  net.joints = survey();
  net.slope = {{70, 140}, 30, 20};
  net.mode = FailureMode::flexural;
  net.window = RangeWindow{72, 104, 30, 70};
  net.selected = {0, 45};
  expect_baseline(draw_stereonet(net, "Window 72..104/30..70", 1200, 800));
}

TEST(StereonetImage, DarkDirectToppling) {
  Stereonet net;
  net.joints = survey();
  net.slope = {{70, 140}, 30, 20};
  net.mode = FailureMode::direct;
  net.theme = Theme::dark;
  expect_baseline(draw_stereonet(net, "Direct toppling", 1200, 800));
}

}  // namespace
}  // namespace talus
