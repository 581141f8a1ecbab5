#include "solve/equilibrium/contact_states.hpp"

#include <algorithm>

#include "contact/contact_law.hpp"

namespace talus {

namespace {

void hold(const Composition& composition, const std::vector<HeldContact>* held) {
  for (NormalContact* normal : composition.normal) normal->hold(held);
  if (composition.shear) composition.shear->hold(held);
}

/// F_t against the displacement that the spring feels. Where a step slides a block less far than friction could push
/// it, a direction that is held as well would overshoot and come out reversed, further with each round.
void take_friction(const ShearContact& shear, int point, const Increment& d, HeldContact& held) {
  const Vec3 spring = shear.spring_force(point, d);
  held.friction = shear.strength(point) * spring.normalized();
  held.across = shear.strength(point) / spring.norm();
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
      if (slid) take_friction(*composition.shear, i, start, held_[i]);
    }
  hold(composition, &held_);
}

ContactStates::Judgement ContactStates::judge(const Composition& composition, const Increment& d) {
  judged_.assign(held_.size(), {});
  Judgement judgement;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const int point = static_cast<int>(i);
    judged_[i].closed = resists_elastically(composition.links->point(point), composition.links->gap(point, d));
  }
  if (composition.shear)
    for (const int i : composition.links->contacts().sheared) {
      judged_[i].shear = composition.shear->mode(i, d);
      const bool closes = judged_[i].closed && !held_[i].closed;  // the round bore no normal force there, (36)
      if (judged_[i].shear != ContactMode::slip || closes) continue;
      take_friction(*composition.shear, i, d, judged_[i]);
      const Vec3 change = judged_[i].friction - composition.shear->force_at(i, d);
      judgement.friction_error = std::max(judgement.friction_error, change.norm() / composition.shear->strength(i));
    }
  for (std::size_t i = 0; i < held_.size(); ++i) judgement.changed += !judged_[i].same_state(held_[i]);
  return judgement;
}

void ContactStates::release(const Composition& composition) const { hold(composition, nullptr); }

}  // namespace talus
