#include "solve/dynamics/stage_clock.hpp"

#include <cmath>

namespace talus {

StageClock::StageClock(const std::vector<Stage>& stages, double rounding) : rounding_(rounding) {
  for (const Stage& stage : stages) {
    // A duration that is a whole number of steps but for rounding has that many; else its last step is shorter.
    const double exact = stage.steps ? *stage.steps : *stage.duration / stage.time_step;
    const long steps = std::lround(std::ceil(exact - rounding_ * exact));
    const double before_last = static_cast<double>(steps - 1) * stage.time_step;
    const double last = stage.steps ? stage.time_step : *stage.duration - before_last;
    spans_.push_back({stage.time_step, before_last + last, steps, last});
  }
}

double StageClock::next_length() const {
  const Span& span = spans_[stage_];
  return is_last() ? span.last : span.length;
}

bool StageClock::is_last() const { return step_ + 1 == spans_[stage_].steps; }

double StageClock::left() const { return start_ + spans_[stage_].duration - time_; }

double StageClock::end() const {
  double end = start_;
  for (std::size_t s = stage_; s < spans_.size(); ++s) end += spans_[s].duration;
  return end;
}

long StageClock::total_steps() const {
  long steps = 0;
  for (const Span& span : spans_) steps += span.steps;
  return steps;
}

void StageClock::advance() {
  const Span& span = spans_[stage_];
  begins_ = false;
  ++step_;
  // Multiples, not a running sum: ten thousand additions of 0.01 would be off by 1e-11 s.
  time_ = step_ == span.steps ? start_ + span.duration : start_ + static_cast<double>(step_) * span.length;
  if (step_ == span.steps) end_stage();
}

void StageClock::advance_by(double length) {
  const Span& span = spans_[stage_];
  begins_ = false;
  time_ += length;
  if (left() > rounding_ * span.length) return;
  time_ = start_ + span.duration;
  end_stage();
}

void StageClock::end_stage() {
  ++stage_;
  step_ = 0;
  begins_ = true;
  start_ = time_;
}

}  // namespace talus
