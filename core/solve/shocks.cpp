#include "solve/shocks.hpp"

#include <algorithm>

namespace talus {

namespace {

/// A push that changes by more than this share of the larger is a blow.
constexpr double sudden = 0.5;

void let_go(BodySet& set, int index) {
  const Body& body = set.bodies[index];
  if (body.rigid >= 0) {
    RigidBody& rigid = set.rigid[body.rigid];
    set.nodes.acceleration[rigid.centre].setZero();
    rigid.moment.setZero();
    return;
  }
  const int first = body.first_carrier >= 0 ? body.first_carrier : body.first_node;
  const int count = body.first_carrier >= 0 ? 4 : body.node_count;
  std::fill_n(set.nodes.acceleration.begin() + first, count, Vec3::Zero());
}

}  // namespace

void Shocks::look(const BodySet& set, const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes) {
  for (const int b : set.moving) {
    before_[b] = pushes_[b];
    pushes_[b].setZero();
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    for (const int side : {0, 1})
      if (!set.bodies[point.bodies[side]].fixed)
        pushes_[point.bodies[side]] += (side == 0 ? 1 : -1) * outcomes[i].normal_force * point.normal;
  }
}

void Shocks::forget(BodySet& set) const {
  for (const int b : set.moving) {
    const double change = (pushes_[b] - before_[b]).norm();
    if (change > sudden * std::max(pushes_[b].norm(), before_[b].norm())) let_go(set, b);
  }
}

}  // namespace talus
