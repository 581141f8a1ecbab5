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
  group_.assign(sizes_.size(), 0);
  kept_awake_.assign(sizes_.size(), 0);
  restless_ = std::move(restless);
  waited_ = count_ = 0;
}

int Sleep::group_of(int body) {
  while (group_[body] != body) body = group_[body] = group_[group_[body]];
  return body;
}

/// Groups the bodies that may move by their contacts, and finds the groups that are kept awake.
void Sleep::join(const BodySet& bodies, const ContactSet& contacts) {
  for (const int b : bodies.moving) {
    group_[b] = b;
    kept_awake_[b] = slow_for_[b] < slow_steps_ || restless_[b];
  }
  const auto keep_awake = [&](int body) { kept_awake_[body] = 1; };
  for (const ContactPoint& point : contacts.points) {
    const auto [a, b] = point.bodies;
    const bool slides = point.mode == ContactMode::slip;
    if (bodies.bodies[a].fixed || bodies.bodies[b].fixed) {
      if (slides) keep_awake(bodies.bodies[a].fixed ? b : a);
      continue;
    }
    if (slides) keep_awake(a);
    group_[std::max(group_of(a), group_of(b))] = std::min(group_of(a), group_of(b));
  }
  for (const int b : bodies.moving)
    if (kept_awake_[b]) keep_awake(group_of(b));
}

bool Sleep::after_step(const BodySet& bodies, const ContactSet& contacts, double length) {
  if (tolerance_ == 0 || !bodies.driven.empty()) return false;
  bool any = false;
  for (const int b : bodies.moving) {
    slow_for_[b] = bodies.bodies[b].largest_displacement <= tolerance_ * sizes_[b] * length ? slow_for_[b] + 1 : 0;
    any = any || slow_for_[b] >= slow_steps_;
  }
  // Not in every step: falling asleep changes the equations, so that neighbours had better do it together.
  if (++waited_ < slow_steps_ || !any) return false;
  waited_ = 0;
  join(bodies, contacts);
  const int before = count_;
  for (const int b : bodies.moving)
    if (!kept_awake_[group_of(b)]) {
      asleep_[b] = 1;
      ++count_;
    }
  return count_ > before;
}

bool Sleep::wake_touched(const BodySet& bodies, const ContactSet& contacts) {
  if (count_ == 0) return false;
  std::vector<int> woken;
  for (const ContactPoint& point : contacts.points)
    for (int k = 0; k < 2; ++k) {
      const int sleeper = point.bodies[k], other = point.bodies[1 - k];
      if (asleep_[sleeper] && !bodies.bodies[other].fixed) woken.push_back(group_of(sleeper));
    }
  if (woken.empty()) return false;
  std::sort(woken.begin(), woken.end());
  for (std::size_t b = 0; b < asleep_.size(); ++b) {
    if (!asleep_[b] || !std::binary_search(woken.begin(), woken.end(), group_of(static_cast<int>(b)))) continue;
    asleep_[b] = 0;
    slow_for_[b] = 0;
    --count_;
    ++wakings_;
  }
  return true;
}

}  // namespace talus
