#include "solve/dynamics/followed_springs.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

double inverse_mass(const Body& body) { return body.fixed ? 0 : 1 / body.mass(); }

void scale(ContactPoint& point, double scaling) {
  const double ratio = scaling / point.penalty_scaling;
  point.penalty_scaling = scaling;
  point.normal_stiffness *= ratio;
  point.shear_stiffness *= ratio;
  point.shear_start *= std::sqrt(std::min(ratio, 1.0));
}

}  // namespace

double FollowedSprings::limit_of(const ContactPoint& point, double length, double gravity, double penetration) const {
  const double first = inverse_mass(bodies_.bodies[point.bodies[0]]),
               second = inverse_mass(bodies_.bodies[point.bodies[1]]);
  const double rate = tolerances_.oscillation / length;
  const double weight = gravity / std::max(first, second);
  return std::max(rate * rate / (first + second), weight / (penetration * point.size));
}

void FollowedSprings::limit(const Project& project, double length, double penetration, FollowedContacts which,
                            ContactSet& contacts) {
  if (which == FollowedContacts::none) return;
  std::vector<ContactPoint>& points = contacts.points;
  const auto is_limited = [&](const ContactPoint& p) { return p.is_new || which == FollowedContacts::all; };
  by_pair_.clear();
  if (std::none_of(points.begin(), points.end(), is_limited)) return;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    if (!project.joints[points[i].joint].normal_stiffness) by_pair_.push_back(i);
  std::sort(by_pair_.begin(), by_pair_.end(), [&](int i, int j) {
    return bodies_of(points[i]) != bodies_of(points[j]) ? bodies_of(points[i]) < bodies_of(points[j]) : i < j;
  });
  for (auto first = by_pair_.begin(); first != by_pair_.end();) {
    const auto last =
        std::find_if(first, by_pair_.end(), [&](int i) { return bodies_of(points[i]) != bodies_of(points[*first]); });
    double stiffness = 0, stiffest = 0;  // N/m, as they would be; scaling of one that goes on
    for (auto i = first; i != last; ++i) {
      stiffness += points[*i].normal_stiffness / points[*i].penalty_scaling;
      if (!is_limited(points[*i])) stiffest = std::max(stiffest, points[*i].penalty_scaling);
    }
    const double followed = limit_of(points[*first], length, project.gravity.norm(), penetration) / stiffness;
    const double least = bodies_.any_moves_by_elements(points[*first].bodies)
                             ? tolerances_.beside_elements / project.solver.contact_stiffness
                             : 0;
    const double scaling = std::max(std::min(std::max(followed, least), 1.0), stiffest);
    for (auto i = first; i != last; ++i) {
      ContactPoint& point = points[*i];
      if (is_limited(point)) scale(point, point.is_new ? scaling : std::min(scaling, point.penalty_scaling));
    }
    first = last;
  }
}

}  // namespace talus
