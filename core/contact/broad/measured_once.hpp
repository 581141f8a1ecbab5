#pragma once

#include <atomic>
#include <cstdint>

namespace talus {

/// Of something that is measured anew for every motion of its body: as of which motion it was. Several threads may ask
/// at once: the first to ask measures, who asks for the same meanwhile waits.
class MeasuredOnce {
 public:
  /// Calls `measure` unless that was done for the motion of number `now`.
  template <class Measure>
  void bring_to(std::uint64_t now, const Measure& measure) {
    if (moves_.load(std::memory_order_acquire) == now || !begin(now)) return;
    measure();
    moves_.store(now, std::memory_order_release);
  }

 private:
  static constexpr std::uint64_t never = ~std::uint64_t{0}, under_way = never - 1;
  /// Whether it is for this thread to measure; if not, it has been done once this returns.
  bool begin(std::uint64_t now);
  std::atomic<std::uint64_t> moves_{never};
};

}  // namespace talus
