#include "render/paint/panel_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace talus {
namespace {

TEST(PanelGrid, IsTheOneInWhichRockIsLargest) {
  EXPECT_EQ(panel_grid(1, 1280, 720), (PanelGrid{1, 1}));
  EXPECT_EQ(panel_grid(2, 1280, 720), (PanelGrid{2, 1}));
  EXPECT_EQ(panel_grid(3, 1280, 720), (PanelGrid{2, 2}));
  EXPECT_EQ(panel_grid(4, 1280, 720), (PanelGrid{2, 2}));
  EXPECT_EQ(panel_grid(4, 2000, 300), (PanelGrid{4, 1})) << "a strip";
  EXPECT_EQ(panel_grid(2, 400, 900), (PanelGrid{1, 2})) << "an upright one";
}

TEST(PanelPlaces, FillAllButLinesOfThreePixels) {
  for (int count = 1; count <= 4; ++count)
    for (const auto& [width, height] : {std::pair{1600, 1000}, {801, 603}, {500, 1200}}) {
      std::vector<int> covered(static_cast<std::size_t>(width * height));
      const std::vector<PanelPlace> places = panel_places(count, width, height);
      ASSERT_EQ(std::ssize(places), count);
      for (const PanelPlace& place : places) {
        EXPECT_GT(place.width, 0);
        ASSERT_LE(place.left + place.width, width);
        ASSERT_LE(place.top + place.height, height);
        for (int y = place.top; y < place.top + place.height; ++y)
          for (int x = place.left; x < place.left + place.width; ++x)
            ++covered[static_cast<std::size_t>(y * width + x)];
        if (&place == &places.front()) continue;
        const PanelPlace& before = *(&place - 1);
        EXPECT_TRUE(place.left == before.left + before.width + 3 || place.top >= before.top + before.height + 3);
      }
      EXPECT_EQ(std::ranges::max(covered), 1) << "none lies over another";
      const auto [columns, rows] = panel_grid(count, width, height);
      const auto between = std::ranges::count(covered, 0);
      EXPECT_LE(between, 3 * ((columns - 1) * height + (rows - 1) * width));
      EXPECT_GE(between, count > 1 ? 3 * std::min(width, height) : 0);
    }
}

}  // namespace
}  // namespace talus
