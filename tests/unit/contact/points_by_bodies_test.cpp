#include "contact/points_by_bodies.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<int> numbers(const PointsByBodies& points, const std::array<int, 2>& bodies) {
  std::vector<int> found;
  for (const auto& entry : points.of(bodies)) found.push_back(entry.point);
  return found;
}

TEST(PointsByBodies, GivesThoseOfTwoBodiesInTheirOrder) {
  std::vector<FoundPoint> points(5);
  const std::array<std::array<int, 2>, 5> bodies = {{{1, 2}, {0, 2}, {1, 2}, {0, 2}, {1, 2}}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].bodies = bodies[i];
    points[i].dropped = i == 3;
  }
  PointsByBodies sorted;
  sorted.sort(points, [](const FoundPoint& p) { return !p.dropped; });
  EXPECT_THAT(numbers(sorted, {1, 2}), ElementsAre(0, 2, 4));
  EXPECT_THAT(numbers(sorted, {0, 2}), ElementsAre(1));
  EXPECT_THAT(numbers(sorted, {2, 1}), IsEmpty());
  sorted.sort({}, [](const FoundPoint&) { return true; });
  EXPECT_THAT(numbers(sorted, {1, 2}), IsEmpty());
}

}  // namespace
}  // namespace talus
