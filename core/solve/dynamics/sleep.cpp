#include "solve/dynamics/sleep.hpp"

#include <algorithm>

namespace talus {

Sleep::Sleep(std::vector<double> sizes, double tolerance, const SleepTolerances& tolerances)
    : sizes_(std::move(sizes)), tolerance_(tolerance), slow_steps_(tolerances.slow_steps) {
  begin_stage(std::vector<bool>(sizes_.size(), false));
}

void Sleep::begin_stage(std::vector<bool> restless) {
  asleep_.assign(sizes_.size(), 0);
  slow_for_.assign(sizes_.size(), 0);
  kept_awake_.assign(sizes_.size(), 0);
  restless_ = std::move(restless);
  waited_ = count_ = 0;
}

void Sleep::keep_awake(const BodySet& bodies, const ContactSet& contacts) {
  const auto is_quiet = [&](int b) { return bodies.bodies[b].fixed || (slow_for_[b] >= slow_steps_ && !restless_[b]); };
  for (const int b : bodies.moving) kept_awake_[b] = !is_quiet(b);
  for (const ContactPoint& point : contacts.points) {
    const bool slides = point.mode == ContactMode::slip;
    const auto [a, b] = point.bodies;
    if (slides || !is_quiet(a)) kept_awake_[b] = 1;
    if (slides || !is_quiet(b)) kept_awake_[a] = 1;
  }
}

const std::vector<int>& Sleep::after_step(const BodySet& bodies, const ContactSet& contacts, double length) {
  falls_asleep_.clear();
  if (tolerance_ == 0 || !bodies.driven.empty()) return falls_asleep_;
  bool any = false;
  for (const int b : bodies.moving) {
    slow_for_[b] = bodies.bodies[b].largest_displacement <= tolerance_ * sizes_[b] * length ? slow_for_[b] + 1 : 0;
    any = any || slow_for_[b] >= slow_steps_;
  }
  // Not in every step: falling asleep changes the equations, so that neighbours had better do it together.
  if (++waited_ < slow_steps_ || !any) return falls_asleep_;
  waited_ = 0;
  keep_awake(bodies, contacts);
  for (const int b : bodies.moving)
    if (!kept_awake_[b]) falls_asleep_.push_back(b);
  for (const int b : falls_asleep_) asleep_[b] = 1;
  count_ += static_cast<int>(falls_asleep_.size());
  return falls_asleep_;
}

void Sleep::wake(std::span<const int> bodies, const std::vector<RestingContact>& resting, int rings) {
  std::vector<char> wakes(asleep_.size(), 0);
  for (const int b : bodies) wakes[b] = asleep_[b];
  for (int ring = 1; ring < rings; ++ring) {
    const std::vector<char> inner = wakes;
    for (const RestingContact& contact : resting) {
      const auto [a, b] = contact.bodies;
      if (inner[a]) wakes[b] = asleep_[b];
      if (inner[b]) wakes[a] = asleep_[a];
    }
  }
  for (std::size_t b = 0; b < asleep_.size(); ++b) {
    if (!wakes[b]) continue;
    asleep_[b] = 0;
    slow_for_[b] = 0;
    --count_;
    ++wakings_;
  }
}

}  // namespace talus
