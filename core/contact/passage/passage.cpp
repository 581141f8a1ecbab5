#include "contact/passage/passage.hpp"

#include <algorithm>
#include <limits>

namespace talus {
namespace {

constexpr double far = 0.5;       // of a thickness: who goes no further is found again by the next search
constexpr int most_halvings = 6;  // what is thinner than 1/64 of the motion could be missed
constexpr double shallow = 0.1;   // of a thickness: who goes through is deeper on the way

}  // namespace

PassageCheck::PassageCheck(const BlockSystem& system, const BodySet& set, std::span<const Surface> surfaces)
    : pieces_(system, set, surfaces),
      set_(set),
      near_(pieces_),
      end_(set.nodes.position),
      displacements_(set.bodies.size(), Vec3::Zero()),
      rotations_(set.bodies.size(), 0.0) {
  for (int b = 0; b < static_cast<int>(surfaces.size()); ++b) thinnest_ = std::min(thinnest_, pieces_.thickness(b));
}

std::optional<DeepPair> PassageCheck::find(const Increment& d, double tolerance,
                                           const std::function<double(int body_a, int body_b)>& known,
                                           std::span<const char> alone) {
  if (!any_goes_far(d, alone)) return std::nullopt;
  measure(d);
  near_.set_span(set_.nodes.position, end_, set_);
  std::vector<char> done(set_.bodies.size(), 0);
  for (const int a : far_) {
    done[a] = 1;
    for (const int b : near_.near(a)) {
      const double size = pieces_.size(a, b);
      const double thickness = std::min(pieces_.thickness(a), pieces_.thickness(b));
      motion_ = (displacements_[a] - displacements_[b]).norm() + rotations_[a] + rotations_[b];
      if (done[b] || !(size < std::numeric_limits<double>::infinity()) || motion_ <= far * thickness) continue;
      bend_ = bend(a) + bend(b);
      between_ = std::min(bend_, shallow * thickness);
      if (!look(a, b, size, tolerance, 0)) continue;
      if (const auto deep = look(a, b, size, tolerance, known(a, b))) return deep;
    }
  }
  return std::nullopt;
}

/// Lists those whose nodes may.
bool PassageCheck::any_goes_far(const Increment& d, std::span<const char> alone) {
  const double least = far * thinnest_;
  const auto goes_far = [&](int b) {
    const Body& body = set_.bodies[b];
    if (body.fixed) return set_.nodes.prescribed[body.first_node].norm() > least;
    if (body.kind == BodyKind::rigid) {
      const RigidBody& one = set_.rigid[body.rigid];
      const double centre = d.segment<3>(3 * set_.nodes.dof_block[one.centre]).norm();
      return centre + one.reach * one.theta(d).norm() > least;
    }
    for (int n = body.first_node; n < body.first_node + body.node_count; ++n)
      if (set_.node_increment(n, d).norm() > least) return true;
    return false;
  };
  far_.clear();
  for (const auto* moved : {&set_.moving, &set_.driven})
    for (const int b : *moved)
      if ((alone.empty() || !alone[b]) && goes_far(b)) far_.push_back(b);
  return !far_.empty();
}

void PassageCheck::measure(const Increment& d) {
  increment_ = &d;
  parts_.clear();
  end_ = set_.nodes.position;
  std::fill(displacements_.begin(), displacements_.end(), Vec3::Zero());
  std::fill(rotations_.begin(), rotations_.end(), 0.0);
  for (const auto* moved : {&set_.moving, &set_.driven})
    for (const int b : *moved) {
      const Body& body = set_.bodies[b];
      const int nodes_end = body.first_node + body.node_count;
      for (int n = body.first_node; n < nodes_end; ++n) {
        end_[n] = position(n, 1);
        displacements_[b] += (end_[n] - set_.nodes.position[n]) / body.node_count;
      }
      for (int n = body.first_node; n < nodes_end; ++n)
        rotations_[b] = std::max(rotations_[b], (end_[n] - set_.nodes.position[n] - displacements_[b]).norm());
    }
}

/// A chord c of an arc of angle θ is c·θ/8 from it.
double PassageCheck::bend(int body) const {
  const Body& of_body = set_.bodies[body];
  if (of_body.kind != BodyKind::rigid || of_body.fixed) return 0;
  return rotations_[body] * set_.rigid[of_body.rigid].theta(*increment_).norm() / 8;
}

std::optional<DeepPair> PassageCheck::look(int a, int b, double size, double tolerance, double known) {
  const double limit = tolerance * size + known;
  for (const auto& [i, j] : near_.near(a, b)) {
    const ConvexPiece first = pieces_.piece(a, i), second = pieces_.piece(b, j);
    const Moment from = at(first, second, 0);
    limit_ = std::max(limit, tolerance * size - from.gap.width);
    if (stay_apart(first, second, from, at(first, second, 1), most_halvings)) continue;
    place(first, second, deep_.time);
    return DeepPair{{a, b}, deepest_corner(deep_.gap.direction, first_, second_), -deep_.gap.width, size};
  }
  return std::nullopt;
}

/// Whether two pieces are no deeper in each other than the limits between two moments.
bool PassageCheck::stay_apart(const ConvexPiece& a, const ConvexPiece& b, const Moment& from, const Moment& to,
                              int halvings) {
  if (to.gap.width < -(to.time < 1 ? limit_ + between_ : limit_)) {
    deep_ = to;
    return false;
  }
  const double length = to.time - from.time;
  if (from.gap.width + to.gap.width > motion_ * length) return true;
  const double enough = bend_ * length * length - limit_ - between_;
  place(a, b, to.time);
  if (from.gap.width >= enough && gap_along(from.gap.direction, first_, second_) >= enough) return true;
  place(a, b, from.time);
  if (to.gap.width >= enough && gap_along(to.gap.direction, first_, second_) >= enough) return true;
  if (halvings == 0) return true;
  const Moment middle = at(a, b, (from.time + to.time) / 2);
  return stay_apart(a, b, from, middle, halvings - 1) && stay_apart(a, b, middle, to, halvings - 1);
}

void PassageCheck::place(const ConvexPiece& a, const ConvexPiece& b, double time) {
  const auto where = [&](int node) { return position(node, time); };
  first_.place(a, where);
  second_.place(b, where);
}

PassageCheck::Moment PassageCheck::at(const ConvexPiece& a, const ConvexPiece& b, double time) {
  place(a, b, time);
  return {time, widest_gap(first_, second_, std::numeric_limits<double>::infinity())};
}

Vec3 PassageCheck::position(int node, double time) {
  const Vec3& start = set_.nodes.position[node];
  if (time == 0) return start;
  if (set_.bodies[set_.nodes.body[node]].fixed) return start + time * set_.nodes.prescribed[node];
  return start + set_.node_increment(node, part(time));
}

/// Unknowns are lengths along the way and angles about an axis: a part of a step is a part of each.
const Increment& PassageCheck::part(double time) {
  if (time == 1) return *increment_;
  const auto [place, is_new] = parts_.try_emplace(time);
  if (is_new) place->second = time * *increment_;
  return place->second;
}

}  // namespace talus
