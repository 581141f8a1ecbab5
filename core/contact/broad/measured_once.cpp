#include "contact/broad/measured_once.hpp"

#include <thread>

namespace talus {

bool MeasuredOnce::begin(std::uint64_t now) {
  std::uint64_t then = moves_.load(std::memory_order_relaxed);
  if (then != now && then != under_way && moves_.compare_exchange_strong(then, under_way, std::memory_order_acquire))
    return true;
  while (moves_.load(std::memory_order_acquire) != now) std::this_thread::yield();
  return false;
}

}  // namespace talus
