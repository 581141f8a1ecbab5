#include "contact/broad/measured_once.hpp"

#include <thread>

namespace talus {

bool MeasuredOnce::begin() {
  State before = State::due;
  if (state_.compare_exchange_strong(before, State::under_way, std::memory_order_acquire)) return true;
  while (!is_done()) std::this_thread::yield();
  return false;
}

}  // namespace talus
