#include "jobs/live_frames.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

std::shared_ptr<const Frame> frame(int index, size_t nodes = 100) {
  auto made = std::make_shared<Frame>();
  made->index = index;
  made->displacement.resize(nodes);
  return made;
}

TEST(LiveFrames, KeepsEveryFrameWithinItsBudget) {
  LiveFrames live(size_t{1} << 20);
  for (int i = 0; i < 50; ++i) live.add(frame(i));
  ASSERT_EQ(live.frames().size(), 50u);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(live.frames()[static_cast<size_t>(i)]->index, i);
}

TEST(LiveFrames, ThinsEvenlyAndKeepsTheNewest) {
  const size_t budget = 20 * frame_bytes(*frame(0));
  LiveFrames live(budget);
  for (int i = 0; i < 1000; ++i) {
    live.add(frame(i));
    size_t bytes = 0;
    for (const auto& kept : live.frames()) bytes += frame_bytes(*kept);
    EXPECT_LE(bytes, budget);
    EXPECT_EQ(live.frames().back()->index, i);
  }
  const auto& kept = live.frames();
  EXPECT_EQ(kept.front()->index, 0);
  EXPECT_GE(kept.size(), 10u);
  const int stride = kept[1]->index - kept[0]->index;
  for (size_t i = 1; i + 1 < kept.size(); ++i) EXPECT_EQ(kept[i]->index - kept[i - 1]->index, stride);
}

}  // namespace
}  // namespace talus
