#pragma once

#include <functional>

/// Work on several cores that comes to the same bits on one: each index is computed by itself, sums are made afterwards
/// in order.
namespace talus {

/// While it lives, parallel work that this thread starts runs on at most `threads` threads; on one where there is none.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
  static int current();

 private:
  int before_;
};

/// Calls work(first, last) for ranges that together are 0…count. `grain`: how many indices are worth a thread's while.
/// The work writes to what belongs to its indices only.
void in_parallel(int count, int grain, const std::function<void(int first, int last)>& work);

}  // namespace talus
