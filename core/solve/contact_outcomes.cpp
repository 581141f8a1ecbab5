#include "solve/contact_outcomes.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

Bond bond_of(bool whole, bool broken) { return whole ? Bond::whole : broken ? Bond::broken : Bond::none; }

}  // namespace

void ContactOutcomes::take(ContactSet& contacts, const ContactLinks& links, const Composition& composition,
                           const Increment& d, bool keep_multipliers) {
  samples_.clear();
  outcomes_.clear();
  max_penetration_ = max_relative_penetration_ = 0;
  for (int i = 0; i < static_cast<int>(contacts.points.size()); ++i) {
    ContactPoint& point = contacts.points[i];
    const double gap = links.gap(i, d), normal = normal_force(point, gap);
    const Vec3 shear = composition.shear ? composition.shear->force_at(i, d) : Vec3(Vec3::Zero());
    const double slip = composition.shear ? composition.shear->slip(i, d) : 0;
    const bool pulled_off = point.bonded && gap > tolerances_.bond_opening * point.size;
    const bool yields = point.bonded && point.tension > 0 && normal <= -point.tension;
    const bool touches = normal > 0 || (point.bonded && !pulled_off);
    point.mode = !touches ? ContactMode::open : slip > 0 ? ContactMode::slip : ContactMode::stick;
    outcomes_.push_back({normal, shear, gap, slip, point.bonded && (slip > 0 || pulled_off || yields)});
    outcomes_.back().multiplier = keep_multipliers ? point.multiplier : 0;
    const bool whole = point.bonded && !outcomes_.back().broke;
    samples_.push_back({point.position,
                        point.normal,
                        {point.bodies[0], point.bodies[1]},
                        point.joint,
                        static_cast<ContactState>(point.mode),
                        normal,
                        shear,
                        point.area,
                        point.friction,
                        whole && point.area > 0 ? point.cohesion / point.area : 0,
                        bond_of(whole, point.broken || outcomes_.back().broke)});
    if (!touches) continue;
    max_penetration_ = std::max(max_penetration_, point.initial_interference - gap);
    max_relative_penetration_ = std::max(max_relative_penetration_, (point.initial_interference - gap) / point.size);
  }
}

void ContactOutcomes::add_to(StepReport& report) const {
  report.contacts = static_cast<int>(samples_.size());
  for (const ContactSample& sample : samples_)
    ++(sample.state == ContactState::open    ? report.open
       : sample.state == ContactState::stick ? report.stick
                                             : report.slip);
  report.max_penetration = std::max(report.max_penetration, max_penetration_);
  report.max_relative_penetration = std::max(report.max_relative_penetration, max_relative_penetration_);
}

ContactSample sample_of(const RestingContact& contact) {
  return {contact.position,
          contact.normal,
          {contact.bodies[0], contact.bodies[1]},
          contact.joint,
          static_cast<ContactState>(contact.mode),
          contact.normal_force,
          contact.shear_force,
          contact.area,
          contact.friction,
          contact.area > 0 ? contact.cohesion / contact.area : 0,
          bond_of(contact.bonded, contact.broken)};
}

double multiplier_error(const ContactLinks& links, const Increment& d) {
  double largest = 0;
  for (int i = 0; i < links.moves().size(); ++i) {
    const ContactPoint& point = links.point(i);
    const double gap = links.gap(i, d);
    const bool pushes_apart = gap > 0 && point.multiplier - point.normal_stiffness * gap > 0;
    if (gap < 0 || pushes_apart) largest = std::max(largest, std::abs(gap) / point.size);
  }
  return largest;
}

void adapt_multipliers(ContactSet& contacts, const ContactLinks& links, const Increment& d) {
  for (int i = 0; i < links.moves().size(); ++i)
    contacts.points[i].multiplier = std::max(0.0, normal_force(contacts.points[i], links.gap(i, d)));
}

}  // namespace talus
