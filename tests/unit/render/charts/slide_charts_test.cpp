#include "render/charts/slide_charts.hpp"

#include <gmock/gmock.h>

#include <regex>

#include "render/paint/svg_painter.hpp"

namespace talus {
namespace {

using testing::HasSubstr;
using testing::Not;

PlanRing rectangle(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

/// Rock that went north: from south to north `length` m, and `width` m from west to east.
Slide slide_of(double width, double length) {
  Slide slide;
  slide.source = {rectangle(0, 0, width, length / 4)};
  slide.deposit.outline = {rectangle(0, 3 * length / 4, width, length)};
  slide.deposit.grid = {0, 3 * length / 4, width / 2, 2, 1, {1, 2}};
  slide.deposit.max_depth = 2;
  slide.run_out.crown_to_toe = {Vec3(width / 2, 0, 50), Vec3(width / 2, length, 0)};
  return slide;
}

std::string painted(const Slide& slide, double width, double height) {
  SvgPainter painter(width, height, rgb(0xffffff));
  deposit_map(slide)(painter, width, height);
  return painter.element();
}

/// How far the points of the widest line reach across, pixels: the frame of the map.
double width_of_map(const std::string& svg) {
  double widest = 0;
  const std::regex line("points=\"([^\"]*)\""), point("(-?[0-9.]+),");
  for (std::sregex_iterator found(svg.begin(), svg.end(), line), end; found != end; ++found) {
    const std::string points = (*found)[1];
    double least = 1e9, most = -1e9;
    for (std::sregex_iterator x(points.begin(), points.end(), point); x != end; ++x) {
      least = std::min(least, std::stod((*x)[1]));
      most = std::max(most, std::stod((*x)[1]));
    }
    widest = std::max(widest, most - least);
  }
  return widest;
}

TEST(DepositMap, OfGroundThatIsLongFromSouthToNorthLiesAcrossAndSaysWhereNorthIs) {
  const std::string svg = painted(slide_of(200, 1200), 700, 300);
  EXPECT_GT(width_of_map(svg), 400);
  EXPECT_THAT(svg, HasSubstr(">north</text>"));
}

TEST(DepositMap, HasNorthUpWhereThatIsNoSmaller) {
  for (const double width : {1000.0, 5000.0})
    EXPECT_THAT(painted(slide_of(width, 1000), 700, 400), Not(HasSubstr(">north")));
}

TEST(DepositMap, IsNotTurnedToStandUprightInANarrowPlace) {
  EXPECT_THAT(painted(slide_of(2000, 1000), 340, 150), Not(HasSubstr(">north")));
}

TEST(DepositMap, OfLongGroundNeedsLessHeight) {
  const double flat = deposit_map_height(slide_of(200, 1200), 700),
               square = deposit_map_height(slide_of(500, 500), 700);
  EXPECT_LT(flat, 200);
  EXPECT_DOUBLE_EQ(deposit_map_height(slide_of(1200, 200), 700), flat) << "whichever way it is long";
  EXPECT_GT(square, 400);
  EXPECT_GT(width_of_map(painted(slide_of(200, 1200), 700, flat)), 350) << "of that height, too";
}

}  // namespace
}  // namespace talus
