#include "render/paint/panel_grid.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace talus
