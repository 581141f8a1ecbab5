#include "solve/fading_inertia.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

/// By which inertia fades with what is out of balance.
constexpr double power = 1.5;
/// What is out of balance by as much as a step before, up to this share, slides or falls: inertia comes back …
constexpr double steady = 1e-3;
/// … by this factor a step.
constexpr double restored = 4;
/// A step with less than all inertia may lead so many times as far as those with all of it.
constexpr double farther = 2;
/// Loose blocks keep as much as a matrix can tell from the stiffness of contacts.
constexpr double least_share = 0x1p-20;
/// What is out of balance by less is so by how exactly steps are solved.
constexpr double at_rest = 1e-10;

/// The next power of two that is not less, in range.
double power_of_two(double share) { return std::clamp(std::exp2(std::ceil(std::log2(share))), least_share, 1.0); }

}  // namespace

bool FadingInertia::led_astray(bool settled, double displacement) const {
  return share_ < 1 && (!settled || displacement > farther * longest_way_);
}

double FadingInertia::share_for(double displacement) const { return share_ * displacement / (farther * longest_way_); }

void FadingInertia::restore(bool settled, double displacement) {
  if (!settled) wanted_ = 1;
  share_ = settled ? power_of_two(share_for(displacement)) : 1;
}

void FadingInertia::taken(double displacement, double imbalance) {
  if (share_ == 1) longest_way_ = std::max(longest_way_, displacement);
  if (imbalance > at_rest) {
    const bool falls = imbalance < (1 - steady) * last_imbalance_;
    wanted_ *= falls ? std::pow(imbalance / last_imbalance_, power) : restored;
    wanted_ = std::clamp(wanted_, least_share, 1.0);
    share_ = power_of_two(std::max(wanted_, share_for(displacement)));
  }
  last_imbalance_ = imbalance;
}

}  // namespace talus
