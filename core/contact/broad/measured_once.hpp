#pragma once

#include <atomic>
#include <cstdint>
#include <span>

namespace talus {

/// Of something that is measured anew once its body has moved: whether that was done. Several threads may ask at once:
/// the first to ask measures, who asks for the same meanwhile waits.
class MeasuredOnce {
 public:
  bool is_done() const { return state_.load(std::memory_order_acquire) == State::done; }

  /// Calls `measure` unless that was done.
  template <class Measure>
  void bring_about(const Measure& measure) {
    if (is_done() || !begin()) return;
    measure();
    state_.store(State::done, std::memory_order_release);
  }

  /// Nobody may ask meanwhile.
  static void forget(std::span<MeasuredOnce> all) {
    for (MeasuredOnce& one : all) one.state_.store(State::due, std::memory_order_relaxed);
  }

 private:
  enum class State : std::uint8_t { due, under_way, done };
  /// Whether it is for this thread to measure; if not, it has been done once this returns.
  bool begin();
  std::atomic<State> state_{State::due};
};

}  // namespace talus
