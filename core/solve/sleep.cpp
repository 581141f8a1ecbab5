#include "solve/sleep.hpp"

#include <algorithm>

namespace talus {

namespace {

/// A body is at rest after so many slow steps: one that turns back, at the top of its way, is slow for one or two.
constexpr int quiet_steps = 20;

}  // namespace

Sleep::Sleep(std::vector<double> sizes, double tolerance) : sizes_(std::move(sizes)), tolerance_(tolerance) {
  begin_stage(std::vector<bool>(sizes_.size(), false));
}

void Sleep::begin_stage(std::vector<bool> restless) {
  asleep_.assign(sizes_.size(), 0);
  quiet_.assign(sizes_.size(), 0);
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
    kept_awake_[b] = quiet_[b] < quiet_steps || restless_[b];
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

bool Sleep::settle(const BodySet& bodies, const ContactSet& contacts, double length) {
  if (tolerance_ == 0 || !bodies.driven.empty()) return false;
  bool any = false;
  for (const int b : bodies.moving) {
    quiet_[b] = bodies.bodies[b].way <= tolerance_ * sizes_[b] * length ? quiet_[b] + 1 : 0;
    any = any || quiet_[b] >= quiet_steps;
  }
  // Not in every step: what falls asleep changes the equations, so that neighbours had better do it together.
  if (++waited_ < quiet_steps || !any) return false;
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
    quiet_[b] = 0;
    --count_;
    ++wakings_;
  }
  return true;
}

}  // namespace talus
