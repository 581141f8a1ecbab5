// The ways of centroids, of boxes that were moved by known vectors.
#include "measures/block_trails.hpp"

#include <gtest/gtest.h>

#include "base/temporary_folder.hpp"
#include "unit/measures/slid_boxes.hpp"

namespace talus {
namespace {

TEST(BlockTrails, AreTheCentroidsOfAllFrames) {
  const BlockSystem system = floor_and_boxes();
  const TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "run.results";
  {
    ResultWriter writer(out, Project(), system, "{}");
    for (int i = 0; i < 3; ++i)
      writer.add_frame(moved_frame(system, {still, {2.0 * i, 0, -1.0 * i}, still, still}, at_rest, 0.5 * i));
  }
  NoProgress nobody;
  const BlockTrails trails = block_trails(ResultReader(out), nobody);
  ASSERT_EQ(trails.times, (std::vector<double>{0, 0.5, 1}));
  EXPECT_NEAR((trails.rest[1] - Vec3(1, 1, 10.5)).norm(), 0, 1e-12);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(((*trails.centroids[static_cast<std::size_t>(i)])[1] - Vec3(1 + 2.0 * i, 1, 10.5 - i)).norm(), 0,
                1e-12);
    EXPECT_NEAR(((*trails.centroids[static_cast<std::size_t>(i)])[2] - Vec3(-3.5, 0.5, 21.5)).norm(), 0, 1e-12);
  }
}

}  // namespace
}  // namespace talus
