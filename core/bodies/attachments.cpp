#include "bodies/attachments.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "bodies/finite_rotation.hpp"

namespace talus {

void Attachments::clear() {
  points_.clear();
  pattern_ = 0;
  terms_.clear();
  turns_.clear();
  pairs_.clear();
  meetings_.clear();
}

void Attachments::add_term(int first, int dof_block, double weight) {
  for (std::size_t i = first; i < terms_.size(); ++i)
    if (terms_[i].dof_block == dof_block) {
      terms_[i].weight += weight;
      return;
    }
  terms_.push_back({dof_block, weight});
}

void Attachments::add_turn(int first, const RigidBody& rigid, int node, double weight) {
  const Vec3 arm = weight * (set_.nodes.position[node] - set_.nodes.position[rigid.centre]);
  for (std::size_t i = first; i < turns_.size(); ++i)
    if (turns_[i].dof_block == rigid.rotation_dof_block) {
      turns_[i].arm += arm;
      return;
    }
  turns_.push_back({.dof_block = rigid.rotation_dof_block, .radius = rigid.radius, .arm = arm, .rigid = &rigid});
}

void Attachments::add(std::span<const int> nodes, std::span<const double> weights) {
  Point point{static_cast<int>(terms_.size()), 0, static_cast<int>(turns_.size()), 0, Vec3::Zero()};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const int node = nodes[k];
    const double weight = weights[k];
    const Body& body = set_.bodies[set_.nodes.body[node]];
    if (body.fixed) {
      point.held += weight * set_.nodes.prescribed[node];
    } else if (body.kind == BodyKind::tetrahedra) {
      add_term(point.term_begin, set_.nodes.dof_block[node], weight);
    } else if (body.kind == BodyKind::affine) {
      const auto& carried = set_.carried[node - body.first_node + body.first_carried];
      for (int c = 0; c < 4; ++c)
        add_term(point.term_begin, set_.nodes.dof_block[body.first_control_node + c], weight * carried[c]);
    } else {
      const RigidBody& rigid = set_.rigid[body.rigid];
      add_term(point.term_begin, set_.nodes.dof_block[rigid.centre], weight);
      add_turn(point.turn_begin, rigid, node, weight);
    }
  }
  point.term_end = static_cast<int>(terms_.size());
  point.turn_end = static_cast<int>(turns_.size());
  points_.push_back(point);
  pattern_ = 0;
}

bool Attachments::may_meet() const {
  const Point& point = points_.back();
  return point.turns() == 2 && point.terms() == 2;
}

void Attachments::let_meet(int carrier) {
  Point& point = points_.back();
  const bool swapped = (terms_[point.term_begin].weight > 0) != (carrier == 0);
  const int first = swapped ? 1 : 0;
  const RigidBody &a = *turns_[point.turn_begin + first].rigid, &b = *turns_[point.turn_begin + 1 - first].rigid;
  if (pairs_.empty() || !pairs_.back().is_of(a, b)) pairs_.emplace_back(set_, a, b);
  point.pair = static_cast<int>(pairs_.size()) - 1;
  point.meeting = static_cast<int>(meetings_.size());
  const double weight = terms_[point.term_begin + first].weight;
  meetings_.emplace_back(weight, turns_[point.turn_begin + first].arm / weight);
}

void Attachments::find_slots(const BlockPattern& pattern) const {
  if (pattern_ == pattern.id()) return;
  pattern_ = pattern.id();
  slot_begin_.clear();
  slots_.clear();
  for (const Point& point : points_) {
    slot_begin_.push_back(static_cast<int>(slots_.size()));
    const auto dof_block = [&](int k) {
      return k < point.terms() ? terms_[point.term_begin + k].dof_block
                               : turns_[point.turn_begin + k - point.terms()].dof_block;
    };
    for (int a = 0; a < point.terms() + point.turns(); ++a)
      for (int b = 0; b <= a; ++b) slots_.push_back(pattern.slot(dof_block(a), dof_block(b)));
  }
}

Attachments::Slots::Slots(const Attachments& attachments, int point, const BlockPattern& pattern)
    : point_(attachments.points_[point]) {
  attachments.find_slots(pattern);
  first_ = attachments.slots_.data() + attachments.slot_begin_[point];
}

Attachments::PairSlots::PairSlots(const Attachments& attachments, int point, const BlockPattern& pattern)
    : slots_(attachments, point, pattern) {
  const Point& of = attachments.points_[point];
  const bool swapped = attachments.pair_of(of).dof_blocks()[0] != attachments.terms_[of.term_begin].dof_block;
  if (swapped) numbers_ = {1, 0, 3, 2};
}

void Attachments::move(const Turn& turn, const Increment& d) {
  turn.unknowns = d.segment<3>(3 * turn.dof_block);
  const Vec3 theta = turn.unknowns / turn.radius;
  const double angle = theta.norm();
  turn.moved = turn_of(theta, turn.arm);
  turn.stretch = angle > 0 && !turn.rigid->touches ? cayley_vector(theta).norm() / angle : 1;
}

Vec3 Attachments::lever_at(const Turn& turn, const Increment& d, Arms arms) {
  const Vec3& moved = moved_by(turn, d);
  return arms == Arms::mean ? Vec3(turn.stretch * (turn.arm + 0.5 * moved)) : Vec3(turn.arm + moved);
}

Vec3 Attachments::increment(int index, const Increment& d) const {
  const Point& point = points_[index];
  if (point.meeting >= 0) return meetings_[point.meeting].increment(pair_of(point).at(d));
  Vec3 u = point.held;
  for (int i = point.term_begin; i < point.term_end; ++i) u += terms_[i].weight * d.segment<3>(3 * terms_[i].dof_block);
  for (int i = point.turn_begin; i < point.turn_end; ++i) u += moved_by(turns_[i], d);
  return u;
}

double Attachments::farthest_against(int index, const Increment& d, const Vec3& direction,
                                     const Eigen::VectorXd& change) const {
  const Point& point = points_[index];
  double sum = 0;
  for (int i = point.term_begin; i < point.term_end; ++i)
    sum += std::min(0.0, terms_[i].weight * direction.dot(change.segment<3>(3 * terms_[i].dof_block)));
  for (int i = point.turn_begin; i < point.turn_end; ++i) {
    const Vec3 theta = change.segment<3>(3 * turns_[i].dof_block) / turns_[i].radius;
    sum += std::min(0.0, direction.dot(theta.cross(arm_at(turns_[i], d))));
  }
  return sum;
}

bool Attachments::bodies_are_together(int index, DisjointSets& sets) const {
  const Point& point = points_[index];
  for (int i = point.term_begin + 1; i < point.term_end; ++i)
    if (sets.first_of(terms_[i].dof_block) != sets.first_of(terms_[point.term_begin].dof_block)) return false;
  return true;
}

void Attachments::join_bodies(int index, DisjointSets& together) const {
  const Point& point = points_[index];
  for (int i = point.term_begin + 1; i < point.term_end; ++i)
    together.join(terms_[point.term_begin].dof_block, terms_[i].dof_block);
}

template <class Use>
void Attachments::visit_force(const Point& point, const Increment& d, const Vec3& force, Arms arms,
                              const Use& use) const {
  for (int i = point.term_begin; i < point.term_end; ++i) use(terms_[i].dof_block, terms_[i].weight * force);
  for (int i = point.turn_begin; i < point.turn_end; ++i)
    use(turns_[i].dof_block, lever_at(turns_[i], d, arms).cross(force) / turns_[i].radius);
}

void Attachments::add_force(int index, const Increment& d, const Vec3& force, Arms arms, Eigen::VectorXd& sum) const {
  const Point& point = points_[index];
  const auto add = [&sum](int dof_block, const Vec3& on_block) { sum.segment<3>(3 * dof_block) += on_block; };
  if (point.meeting < 0) return visit_force(point, d, force, arms, add);
  const RigidPair& pair = pair_of(point);
  MeetingForces of_pair;
  of_pair.add(pair.at(d), meetings_[point.meeting], force, arms);
  of_pair.take_out(pair, pair.at(d), arms, add);
}

void Attachments::add_spring(int index, const Increment& d, const Mat3& spring, SymmetricBlocks& sum) const {
  const Point& point = points_[index];
  const Slots slots(*this, index, sum.pattern());
  for (int a = point.term_begin; a < point.term_end; ++a)
    for (int b = point.term_begin; b <= a; ++b)
      sum.add_at(slots.of_terms(a, b), terms_[a].dof_block, terms_[b].dof_block,
                 terms_[a].weight * terms_[b].weight * spring);
  for (int a = point.turn_begin; a < point.turn_end; ++a) {
    const Mat3 turned = cross_times(arm_at(turns_[a], d), spring) / turns_[a].radius;  // (∂u/∂θ)ᵀ spring
    for (int b = point.term_begin; b < point.term_end; ++b)
      sum.add_at(slots.of_turn_and_term(a, b), turns_[a].dof_block, terms_[b].dof_block, terms_[b].weight * turned);
    for (int b = point.turn_begin; b <= a; ++b)
      sum.add_at(slots.of_turns(a, b), turns_[a].dof_block, turns_[b].dof_block,
                 -times_cross(turned, arm_at(turns_[b], d)) / turns_[b].radius);
  }
}

void Attachments::add_other_spring(int index, const Increment& d, const Mat3& spring, UnsymmetricBlocks& sum) const {
  const Point& point = points_[index];
  const Slots slots(*this, index, sum.pattern());
  for (int a = point.term_begin; a < point.term_end; ++a) {
    for (int b = point.term_begin; b < point.term_end; ++b)
      sum.add_at(slots.of_terms(a, b), terms_[a].dof_block, terms_[b].dof_block,
                 terms_[a].weight * terms_[b].weight * spring);
    for (int b = point.turn_begin; b < point.turn_end; ++b) {
      const int slot = slots.of_turn_and_term(b, a);
      const Mat3 arm = cross_matrix(arm_at(turns_[b], d)) / turns_[b].radius;
      sum.add_at(slot, terms_[a].dof_block, turns_[b].dof_block, -terms_[a].weight * spring * arm);
      sum.add_at(slot, turns_[b].dof_block, terms_[a].dof_block, terms_[a].weight * arm * spring);
    }
  }
  for (int a = point.turn_begin; a < point.turn_end; ++a)
    for (int b = point.turn_begin; b < point.turn_end; ++b)
      sum.add_at(slots.of_turns(a, b), turns_[a].dof_block, turns_[b].dof_block,
                 -cross_matrix(arm_at(turns_[a], d)) * spring * cross_matrix(arm_at(turns_[b], d)) /
                     (turns_[a].radius * turns_[b].radius));
}

void Attachments::add_lever_difference(int index, const Increment& d, const Mat3& spring, Arms arms,
                                       UnsymmetricBlocks& sum) const {
  if (arms == Arms::end) return;
  const Point& point = points_[index];
  const Slots slots(*this, index, sum.pattern());
  for (int a = point.turn_begin; a < point.turn_end; ++a) {
    const Turn& turn = turns_[a];
    const Mat3 left = cross_times(lever_at(turn, d, arms) - arm_at(turn, d), spring) / turn.radius;
    for (int b = point.term_begin; b < point.term_end; ++b)
      sum.add_at(slots.of_turn_and_term(a, b), turn.dof_block, terms_[b].dof_block, terms_[b].weight * left);
    for (int b = point.turn_begin; b < point.turn_end; ++b)
      sum.add_at(slots.of_turns(a, b), turn.dof_block, turns_[b].dof_block,
                 -times_cross(left, arm_at(turns_[b], d)) / turns_[b].radius);
  }
}

void Attachments::add_turning(int index, const Increment& d, const Vec3& force, Arms arms,
                              UnsymmetricBlocks& sum) const {
  const Point& point = points_[index];
  for (int i = point.turn_begin; i < point.turn_end; ++i) {
    const Turn& turn = turns_[i];
    const Vec3 arm = (arms == Arms::mean ? 0.5 * turn.stretch : 1) * arm_at(turn, d);
    sum.add(turn.dof_block, turn.dof_block,
            (arm * force.transpose() - arm.dot(force) * Mat3::Identity()) / (turn.radius * turn.radius));
  }
}

void Attachments::Forces::add(int index, std::size_t kind, const Vec3& force) {
  const Point& point = moves_.points_[index];
  const auto list = [&](int dof_block, const Vec3& on_block) { lists_[kind].push_back({dof_block, on_block}); };
  if (point.meeting < 0) return moves_.visit_force(point, d_, force, arms_, list);
  if (pair_ != point.pair) {
    finish_pair();
    pair_ = point.pair;
  }
  of_pair_[kind].add(moves_.pairs_[pair_].at(d_), moves_.meetings_[point.meeting], force, arms_);
}

void Attachments::Forces::finish_pair() {
  if (pair_ < 0) return;
  const RigidPair& pair = moves_.pairs_[pair_];
  for (std::size_t kind = 0; kind < lists_.size(); ++kind)
    of_pair_[kind].take_out(pair, pair.at(d_), arms_, [&](int dof_block, const Vec3& force) {
      lists_[kind].push_back({dof_block, force});
    });
  pair_ = -1;
}

void Attachments::PairSums::add(int index, const PointTangent& at) {
  if (!at.bears && !at.has_other && !at.has_set_down) return;
  const Point& point = moves_.points_[index];
  if (first_ < 0 || moves_.points_[first_].pair != point.pair) {
    finish_pair();
    first_ = index;
  }
  pair_.add(moves_.pair_of(point).at(d_), moves_.meetings_[point.meeting], at);
}

void Attachments::PairSums::finish_pair() {
  if (first_ < 0) return;
  const RigidPair& pair = moves_.pair_of(moves_.points_[first_]);
  const RigidPair::State& state = pair.at(d_);
  PairSum& sum = list_.emplace_back();
  sum.point = first_;
  sum.dof_blocks = pair.dof_blocks();
  pair_.find_symmetric(pair, state, sum.symmetric);
  if (with_unsymmetric_) pair_.find_unsymmetric(pair, state, sum.unsymmetric);
  pair_.clear();
  first_ = -1;
}

void Attachments::add(std::span<const PairSum> pairs, SymmetricBlocks* symmetric, UnsymmetricBlocks* unsymmetric,
                      Columns columns) const {
  for (const PairSum& sum : pairs) {
    const auto& dof_blocks = sum.dof_blocks;
    if (std::ranges::none_of(dof_blocks, [&](int dof_block) { return columns.have(dof_block); })) continue;
    const auto add_to = [&](auto& matrix, const PairBlocks& blocks, bool lower_alone) {
      const PairSlots slots(*this, sum.point, matrix.pattern());
      for (int a = 0; a < RigidPair::part_count; ++a)
        for (int b = 0; b < (lower_alone ? a + 1 : RigidPair::part_count); ++b)
          if (columns.have(std::min(dof_blocks[a], dof_blocks[b])))
            matrix.add_at(slots.of(a, b), dof_blocks[a], dof_blocks[b], PairSlots::block(blocks, a, b));
    };
    if (symmetric) add_to(*symmetric, sum.symmetric, true);
    if (unsymmetric) add_to(*unsymmetric, sum.unsymmetric, false);
  }
}

void Attachments::make_room(std::span<const PairSum> pairs, UnsymmetricBlocks& unsymmetric) const {
  for (const PairSum& sum : pairs) {
    const PairSlots slots(*this, sum.point, unsymmetric.pattern());
    for (int a = 0; a < RigidPair::part_count; ++a)
      for (int b = 0; b <= a; ++b) unsymmetric.make_room(slots.of(a, b), sum.dof_blocks[a], sum.dof_blocks[b]);
  }
}

void Attachments::add_tangent(int index, const Increment& d, Arms arms, const PointTangent& at,
                              SymmetricBlocks* symmetric, UnsymmetricBlocks* unsymmetric) const {
  if (symmetric && at.bears) add_spring(index, d, at.spring, *symmetric);
  if (symmetric && at.has_set_down) add_spring(index, d, at.set_down, *symmetric);
  if (!unsymmetric) return;
  if (at.has_other) add_other_spring(index, d, at.other, *unsymmetric);
  if (points_[index].turns() == 0 || !(at.bears || at.has_other)) return;
  add_turning(index, d, at.force, arms, *unsymmetric);
  add_lever_difference(index, d, at.spring + at.other, arms, *unsymmetric);
}

}  // namespace talus
