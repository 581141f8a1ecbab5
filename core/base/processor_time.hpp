#pragma once

#include <ctime>

namespace talus {

/// Seconds that the processor has worked for this thread: a busy machine does not lengthen them.
inline double processor_seconds_of_thread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace talus
