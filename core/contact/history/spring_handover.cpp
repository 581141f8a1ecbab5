#include "contact/history/spring_handover.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "contact/contact_law.hpp"
#include "contact/history/contact_memory.hpp"

namespace talus {

namespace {

constexpr double rounding_of_given = 1e-9;  // – of it: forces that go on stay what they are to the bit

/// What springs hold beside their multipliers [J].
struct SpringEnergy {
  double normal = 0, shear = 0;

  void add(const SpringEnergy& other, double part) {
    normal += part * other.normal;
    shear += part * other.shear;
  }
};

SpringEnergy energy_of(const ContactHistory& history) {
  return {0.5 * (history.normal_force - history.multiplier) * std::max(0.0, -history.gap), history.shear_energy};
}

SpringEnergy energy_of(const ContactPoint& point) {
  const double compression = std::max(0.0, -point.gap);
  return {0.5 * point.normal_stiffness * compression * compression, shear_spring_energy(point, point.shear_start)};
}

/// The part of an area that another one does not account for. A vertex or an edge, which has none, is all or nothing.
double part_beyond(double other, double area) {
  return area > 0 ? std::max(0.0, 1 - other / area) : static_cast<double>(other > 0);
}

/// What springs between two bodies held that have ended, or have less of the area.
SpringEnergy given_by(const ContactMemory& memory, const std::array<int, 2>& bodies,
                      std::span<const ContactPoint> points) {
  SpringEnergy sum;
  memory.visit_between(bodies, [&](const ContactHistory& history) {
    const auto point = std::ranges::lower_bound(points, history.key, {}, &ContactPoint::key);
    const bool goes_on = point != points.end() && point->key == history.key;
    sum.add(energy_of(history), goes_on ? part_beyond(point->area, history.area) : 1);
  });
  return sum;
}

/// By which the energy that was gained must be multiplied.
double factor(double given, double gained) { return gained * (1 - rounding_of_given) > given ? given / gained : 1; }

/// Of a strain by which the energy grows, of which `gained` was, times `factor`.
double strain_left(double gained, double factor) { return factor < 1 ? std::sqrt(1 - gained * (1 - factor)) : 1; }

}  // namespace

void SpringHandover::find_successors(const ContactMemory& memory, std::span<const int> numbers,
                                     std::span<const ContactPoint> points) {
  successors_.clear();
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const ContactPoint& point = points[i];
    if (point.is_new) continue;
    const ContactHistory* own = memory.own(numbers[i]);
    const double gained = own ? part_beyond(own->area, point.area) : 1;
    if (gained > 0) successors_.push_back({{point.bodies[0], point.bodies[1]}, i, gained});
  }
  std::ranges::sort(successors_);
}

void SpringHandover::limit(const ContactMemory& memory, std::span<const int> numbers, std::span<ContactPoint> points) {
  find_successors(memory, numbers, points);
  for (auto first = successors_.begin(); first != successors_.end();) {
    const auto last = std::find_if(first, successors_.end(),
                                   [&](const Successor& successor) { return successor.bodies != first->bodies; });
    SpringEnergy gained;
    for (auto successor = first; successor != last; ++successor)
      gained.add(energy_of(points[successor->point]), successor->gained);
    const SpringEnergy given = given_by(memory, first->bodies, points);
    const double normal = factor(given.normal, gained.normal), shear = factor(given.shear, gained.shear);
    for (; first != last; ++first) {
      ContactPoint& point = points[first->point];
      const double relieved = (1 - strain_left(first->gained, normal)) * std::max(0.0, -point.gap);
      point.gap += relieved;
      point.initial_interference += relieved;
      point.shear_start *= strain_left(first->gained, shear);
    }
  }
}

}  // namespace talus
