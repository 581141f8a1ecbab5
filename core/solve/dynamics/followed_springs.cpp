#include "solve/dynamics/followed_springs.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/impulse.hpp"

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

/// Down to this scaling, with as much energy as before. What the spring gives more by for that was initial
/// interference, into which stiffer springs had turned it.
void soften(ContactPoint& point, double scaling) {
  const double more = -point.gap * (std::sqrt(point.penalty_scaling / scaling) - 1);
  const double given_back = std::clamp(more, 0.0, std::max(point.initial_interference, 0.0));
  scale(point, scaling);
  point.gap -= given_back;
  point.initial_interference -= given_back;
}

}  // namespace

double FollowedSprings::limit_of(const ContactPoint& point, double length, double gravity, double penetration) const {
  const double first = inverse_mass(bodies_.bodies[point.bodies[0]]),
               second = inverse_mass(bodies_.bodies[point.bodies[1]]);
  const double rate = tolerances_.oscillation / length;
  const double weight = gravity / std::max(first, second);
  return std::max(rate * rate / (first + second), weight / (penetration * point.size));
}

/// Whether the bodies of some of these points go farther against each other in a step than these may penetrate: what
/// springs sink by when they soften is nothing to that.
bool FollowedSprings::any_moves(std::span<const int> points, double length, double penetration,
                                const ContactSet& contacts) const {
  return std::ranges::any_of(points, [&](int i) {
    const ContactPoint& point = contacts.points[i];
    const auto [nodes, weights] = contacts.stencil(point);
    return length * velocity_of(bodies_, nodes, weights, length).norm() > penetration * point.size;
  });
}

double FollowedSprings::relax(std::span<const int> going_on, double stiffest, double least, double length,
                              double penetration, ContactSet& contacts) const {
  double compression = 0;  // of the penetration that they may have
  for (const int i : going_on) {
    const ContactPoint& point = contacts.points[i];
    const double allowed = penetration * point.size;
    const bool is_deep = point.initial_interference > tolerances_.relaxed_interference * allowed;
    if (point.bonded || point.multiplier != 0 || is_deep) return stiffest;
    compression = std::max(compression, -point.gap / allowed);
  }
  const double relaxed = std::max(least, stiffest * compression / tolerances_.relaxed_compression);
  if (relaxed > tolerances_.worthwhile_softening * stiffest || !any_moves(going_on, length, penetration, contacts))
    return stiffest;
  for (const int i : going_on)
    if (contacts.points[i].penalty_scaling > relaxed) soften(contacts.points[i], relaxed);
  return relaxed;
}

void FollowedSprings::limit(const Project& project, double length, double penetration, FollowedContacts which,
                            ContactSet& contacts) {
  if (which == FollowedContacts::none) return;
  std::vector<ContactPoint>& points = contacts.points;
  const auto is_limited = [&](const ContactPoint& p) { return p.is_new || which == FollowedContacts::all; };
  by_pair_.clear();
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    if (!project.joints[points[i].joint].normal_stiffness) by_pair_.push_back(i);
  for (auto first = by_pair_.begin(); first != by_pair_.end();) {
    const auto last =
        std::find_if(first, by_pair_.end(), [&](int i) { return bodies_of(points[i]) != bodies_of(points[*first]); });
    double stiffness = 0, stiffest = 0;  // N/m, as they would be; scaling of one that goes on
    going_on_.clear();
    for (auto i = first; i != last; ++i) {
      stiffness += points[*i].normal_stiffness / points[*i].penalty_scaling;
      if (is_limited(points[*i])) continue;
      stiffest = std::max(stiffest, points[*i].penalty_scaling);
      going_on_.push_back(*i);
    }
    const double followed = limit_of(points[*first], length, project.gravity.norm(), penetration) / stiffness;
    const double beside_elements = bodies_.any_moves_by_elements(points[*first].bodies)
                                       ? tolerances_.beside_elements / project.solver.contact_stiffness
                                       : 0;
    const double least = std::min(std::max(followed, beside_elements), 1.0);
    if (stiffest > 1) stiffest = relax(going_on_, stiffest, least, length, penetration, contacts);
    const double scaling = std::max(least, stiffest);
    for (auto i = first; i != last; ++i) {
      ContactPoint& point = points[*i];
      if (is_limited(point)) scale(point, point.is_new ? scaling : std::min(scaling, point.penalty_scaling));
    }
    first = last;
  }
}

}  // namespace talus
