#pragma once

#include "run/run.hpp"

namespace talus {

/// Lets a run go on to its end and takes no note of it.
struct SilentObserver final : RunObserver {
  void on_step(const StepReport&, const HistoryRow&, double) override {}
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override { return true; }
};

}  // namespace talus
