#include "solve/contact_outcomes.hpp"

#include <algorithm>

namespace talus {

namespace {

/// A bond that has opened by more than this share of the mesh size is broken.
constexpr double opening_tolerance = 2e-4;

}  // namespace

void ContactOutcomes::take(ContactSet& contacts, const ContactLinks& links, const Composition& composition,
                           const Increment& d, bool keep_multipliers) {
  forces_.resize(contacts.points.size());
  outcomes_.resize(contacts.points.size());
  for (int i = 0; i < static_cast<int>(contacts.points.size()); ++i) {
    ContactPoint& point = contacts.points[i];
    ContactForces& force = forces_[i];
    force.gap = links.gap(i, d);
    force.normal = normal_force(point, force.gap);
    force.shear = composition.shear ? composition.shear->force(i, d) : Vec3(Vec3::Zero());
    const double slip = composition.shear ? composition.shear->slip(i, d) : 0;
    const bool pulled_off = point.bonded && force.gap > opening_tolerance * point.size;
    const bool yields = point.bonded && point.tension > 0 && force.normal <= -point.tension;
    const bool touches = force.normal > 0 || (point.bonded && !pulled_off);
    point.mode = force.mode = !touches ? ContactMode::open : slip > 0 ? ContactMode::slip : ContactMode::stick;
    outcomes_[i] = {force.normal, force.shear, force.gap, slip, point.bonded && (slip > 0 || pulled_off || yields)};
    outcomes_[i].multiplier = keep_multipliers ? std::max(0.0, force.normal) : 0;
  }
}

void ContactOutcomes::add_to(StepReport& report, const ContactSet& contacts) const {
  report.contacts = static_cast<int>(forces_.size());
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const ContactForces& force = forces_[i];
    ++(force.mode == ContactMode::open ? report.open : force.mode == ContactMode::stick ? report.stick : report.slip);
    if (force.mode == ContactMode::open) continue;
    const double penetration = contacts.points[i].overlap - force.gap;
    report.max_penetration = std::max(report.max_penetration, penetration);
    report.max_relative_penetration = std::max(report.max_relative_penetration, penetration / contacts.points[i].size);
  }
}

std::vector<ContactSample> ContactOutcomes::samples(const ContactSet& contacts) const {
  std::vector<ContactSample> samples;
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    samples.push_back({point.position,
                       point.normal,
                       {point.bodies[0], point.bodies[1]},
                       point.joint,
                       static_cast<ContactState>(forces_[i].mode),
                       forces_[i].normal,
                       forces_[i].shear,
                       point.area});
  }
  return samples;
}

double relative_penetration(const ContactLinks& links, const Increment& d) {
  double deepest = 0;
  for (int i = 0; i < links.moves().size(); ++i) deepest = std::max(deepest, -links.gap(i, d) / links.point(i).size);
  return deepest;
}

void raise_multipliers(ContactSet& contacts, const ContactLinks& links, const Increment& d) {
  for (int i = 0; i < links.moves().size(); ++i)
    contacts.points[i].multiplier = std::max(0.0, normal_force(contacts.points[i], links.gap(i, d)));
}

}  // namespace talus
