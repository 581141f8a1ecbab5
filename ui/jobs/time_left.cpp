#include "jobs/time_left.hpp"

namespace talus {

namespace {
constexpr double least_spent = 0.5;       // s: before, start-up costs colour the rate
constexpr double window_share = 1 / 3.0;  // of the time spent: shorter windows make the number jump
}  // namespace

void TimeLeft::update(double spent, double fraction) {
  moments_.push_back({spent, fraction});
  const double begin = spent * (1 - window_share);
  while (moments_.size() > 2 && moments_[1].spent <= begin) moments_.pop_front();
}

std::optional<double> TimeLeft::seconds() const {
  if (moments_.size() < 2 || spent() < least_spent) return std::nullopt;
  const double time = moments_.back().spent - moments_.front().spent;
  const double progress = moments_.back().fraction - moments_.front().fraction;
  if (time <= 0 || progress <= 0) return std::nullopt;
  return (1 - moments_.back().fraction) * time / progress;
}

}  // namespace talus
