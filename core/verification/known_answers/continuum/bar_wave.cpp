#include "verification/known_answers/continuum/bar_wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

double SmoothPulse::force(double time) const {
  if (time <= 0 || time >= duration) return 0;
  const double sine = std::sin(std::numbers::pi * time / duration);
  return peak * sine * sine;
}

double SmoothPulse::impulse(double time) const {
  const double t = std::clamp(time, 0.0, duration), turn = 2 * std::numbers::pi / duration;
  return peak / 2 * (t - std::sin(turn * t) / turn);
}

double ElasticBar::wave_speed() const { return std::sqrt(young / density); }

double ElasticBar::travel_time() const { return length / wave_speed(); }

double ElasticBar::free_end_displacement(const SmoothPulse& push, double time) const {
  return 2 * push.impulse(time - travel_time()) / (density * wave_speed() * area);
}

}  // namespace talus
