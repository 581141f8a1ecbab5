#include "base/parallel.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace talus {
namespace {

TEST(Parallel, EveryIndexIsWorkedOnOnceOnOneThreadAndOnFour) {
  for (const int threads : {1, 4}) {
    const ThreadLimit limit(threads);
    std::vector<std::atomic<int>> visits(1000);
    in_parallel(1000, 10, [&](int first, int last) {
      for (int i = first; i < last; ++i) ++visits[i];
    });
    for (const auto& count : visits) EXPECT_EQ(count, 1);
  }
}

TEST(Parallel, WorksOnMoreThreadsOnlyWhereItIsAllowed) {
  const auto threads_seen = [] {
    std::set<std::thread::id> seen;
    std::mutex guard;
    in_parallel(64, 1, [&](int, int) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      const std::lock_guard lock(guard);
      seen.insert(std::this_thread::get_id());
    });
    return seen.size();
  };
  EXPECT_EQ(ThreadLimit::current(), 1);
  EXPECT_EQ(threads_seen(), 1U);
  {
    const ThreadLimit two(2);
    EXPECT_EQ(ThreadLimit::current(), 2);
    EXPECT_LE(threads_seen(), 2U);
    std::thread([] { EXPECT_EQ(ThreadLimit::current(), 1) << "another thread's limit is its own"; }).join();
  }
  EXPECT_EQ(ThreadLimit::current(), 1);
}

TEST(Parallel, NothingToDoIsNoWorkAtAllOrAnEmptyRange) {
  const ThreadLimit limit(2);
  int sum = 0;
  in_parallel(0, 10, [&](int first, int last) { sum += last - first; });
  EXPECT_EQ(sum, 0);
}

}  // namespace
}  // namespace talus
