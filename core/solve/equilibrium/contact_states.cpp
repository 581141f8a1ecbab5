#include "solve/equilibrium/contact_states.hpp"

#include <algorithm>

#include "contact/contact_law.hpp"

namespace talus {

namespace {

void hold(const Composition& composition, const std::vector<HeldContact>* held) {
  for (NormalContact* normal : composition.normal) normal->hold(held);
  if (composition.shear) composition.shear->hold(held);
}

/// F_t against the displacement that the spring feels [N].
Vec3 friction(const ShearContact& shear, int point, const Increment& d) {
  return shear.strength(point) * shear.spring_force(point, d).normalized();
}

}  // namespace

void ContactStates::begin(const Composition& composition, double touching, const Increment& start) {
  release(composition);
  held_.clear();
  if (!composition.links) return;
  const ContactSet& contacts = composition.links->contacts();
  held_.resize(contacts.points.size());
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    held_[i].closed = point.is_new ? touches(point, point.gap, touching) : point.mode != ContactMode::open;
  }
  if (composition.shear)
    for (const int i : contacts.sheared) {
      const ContactPoint& point = contacts.points[i];
      const bool slid = point.mode == ContactMode::slip && composition.shear->strength(i) > 0 &&
                        composition.shear->spring_force(i, start).norm() > 0;
      if (held_[i].closed) held_[i].shear = slid ? ContactMode::slip : ContactMode::stick;
      if (slid) held_[i].friction = friction(*composition.shear, i, start);
    }
  hold(composition, &held_);
}

bool ContactStates::judge(const Composition& composition, const Increment& d) {
  judged_.assign(held_.size(), {});
  bool same = true;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const int point = static_cast<int>(i);
    judged_[i].closed = resists_elastically(composition.links->point(point), composition.links->gap(point, d));
  }
  if (composition.shear)
    for (const int i : composition.links->contacts().sheared) {
      judged_[i].shear = composition.shear->mode(i, d);
      if (judged_[i].shear == ContactMode::slip) judged_[i].friction = friction(*composition.shear, i, d);
    }
  for (std::size_t i = 0; i < held_.size(); ++i) same = same && judged_[i].same_state(held_[i]);
  return same;
}

bool ContactStates::any_slides() const {
  return std::any_of(judged_.begin(), judged_.end(), [](const HeldContact& c) { return c.shear == ContactMode::slip; });
}

void ContactStates::release(const Composition& composition) const { hold(composition, nullptr); }

}  // namespace talus
