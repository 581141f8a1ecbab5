#include "solve/stage_clock.hpp"

#include <cmath>

namespace talus {

StageClock::StageClock(const std::vector<Stage>& stages) : stages_(stages) {
  for (const Stage& stage : stages_) {
    // A duration that is a whole number of steps up to round-off has that many; else its last step is shorter.
    const double exact = stage.steps ? *stage.steps : *stage.duration / stage.time_step;
    const long steps = std::lround(std::ceil(exact - 1e-9 * exact));
    const double last =
        stage.steps ? stage.time_step : *stage.duration - static_cast<double>(steps - 1) * stage.time_step;
    spans_.push_back({end_, stage.time_step, steps, last});
    end_ += static_cast<double>(steps - 1) * stage.time_step + last;
    total_steps_ += steps;
  }
}

double StageClock::next_length() const {
  const Span& span = spans_[stage_];
  return step_ + 1 == span.steps ? span.last : span.length;
}

void StageClock::advance() {
  const Span& span = spans_[stage_];
  const double length = next_length();
  ++step_;
  // Multiples, not a running sum: ten thousand additions of 0.01 would be off by 1e-11 s.
  time_ = step_ == span.steps ? span.start + static_cast<double>(span.steps - 1) * span.length + length
                              : span.start + static_cast<double>(step_) * span.length;
  if (step_ < span.steps) return;
  step_ = 0;
  ++stage_;
}

}  // namespace talus
