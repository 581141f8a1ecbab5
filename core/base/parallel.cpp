#include "base/parallel.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

namespace talus {

namespace {

thread_local int limit = 1;

/// Kept from call to call: to make one takes longer than a small piece of work.
tbb::task_arena& arena_of(int threads) {
  thread_local tbb::task_arena arena;
  if (!arena.is_active() || arena.max_concurrency() != threads) {
    arena.terminate();
    arena.initialize(threads);
  }
  return arena;
}

}  // namespace

ThreadLimit::ThreadLimit(int threads) : before_(limit) { limit = std::max(1, threads); }
ThreadLimit::~ThreadLimit() { limit = before_; }
int ThreadLimit::current() { return limit; }

void in_parallel(int count, int grain, const std::function<void(int, int)>& work) {
  if (limit == 1 || count <= grain) {
    work(0, count);
    return;
  }
  arena_of(limit).execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, count, grain),
                      [&](const tbb::blocked_range<int>& range) { work(range.begin(), range.end()); });
  });
}

}  // namespace talus
