#include "contact/broad/odometers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {
namespace {

constexpr double farthest = 1e200;  // m: stands for a displacement that is no number

}  // namespace

void Odometers::add(int body, double displacement) {
  Reading& reading = bodies_[body];
  reading.pace = displacement < farthest ? displacement : farthest;
  // Rounded up, so that it stays a bound however many steps are summed.
  reading.travelled = std::nextafter(reading.travelled + reading.pace, std::numeric_limits<double>::infinity());
  ++reading.moves;
  if (!reading.is_listed) moved_.push_back(body);
  reading.is_listed = true;
}

void Odometers::read(int body, int first, int count, std::span<const Vec3> x) {
  if (last_.size() != x.size()) last_.assign(x.begin(), x.end());
  double displacement = 0;
  bool has_moved = false;
  for (int i = first; i < first + count; ++i) {
    if (x[i] == last_[i]) continue;
    const double step = (x[i] - last_[i]).lpNorm<Eigen::Infinity>();
    displacement = std::isfinite(step) ? std::max(displacement, step) : farthest;
    has_moved = true;
    last_[i] = x[i];
  }
  if (has_moved) {
    add(body, displacement);
  } else {
    bodies_[body].pace = 0;
  }
}

void Odometers::have_seen() {
  for (int body : moved_) bodies_[body].is_listed = false;
  moved_.clear();
}

}  // namespace talus
