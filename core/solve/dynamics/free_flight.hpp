#pragma once

#include <span>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "contact/contact_point.hpp"
#include "effects/compose.hpp"
#include "solve/dynamics/integration_reserve.hpp"

namespace talus {

/// Bodies that nothing but weight and each other acts on, one by one or in groups that touch (docs/theory.md, "Free
/// flight"). They keep their angular momentum: what time integration of bodies that deform misses, and what equal and
/// opposite forces turn two bodies by whose points slide on each other, is made up for at the end of a step by the
/// smallest change of velocities over the mass. It is a turn of the whole group, by which no two of them part or close
/// (compare projections onto invariants, Hairer, Lubich & Wanner 2006, IV.4). Energy that this would make comes out of
/// what they move beside their common rigid motion, and so does what rings in a body that flies alone.
class FreeFlight {
 public:
  /// `set` outlives it.
  explicit FreeFlight(BodySet& set) : set_(set), flies_(set.bodies.size(), false) {}

  /// Whether there are no other loads, constraints and damping.
  static bool is_possible(const Composition& composition);
  /// No body is known to fly.
  void begin_stage() { flies_.assign(flies_.size(), false); }
  /// A step is about to be accepted: bodies are as at its start, and outcomes those at its end.
  void note_start(const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes);
  /// Bodies have moved, and have the velocities that contacts and impacts gave them. What they gain by it comes out of
  /// `reserve`: time integration had taken it from them.
  void end_step(IntegrationReserve& reserve);
  /// Whether nothing but weight acts on a body, by the last step.
  bool flies(int body) const { return flies_[body]; }

  /// What it remembers from step to step.
  void archive(auto& state) { state(flies_); }

 private:
  /// Of some bodies: mass [kg], and about a point near them Σ m r [kg m], Σ m v [N s], Σ r × m v [N m s] and
  /// Σ m r rᵀ [kg m²].
  struct Sums {
    double mass = 0;
    Vec3 first = Vec3::Zero(), linear = Vec3::Zero(), angular = Vec3::Zero();
    Mat3 second = Mat3::Zero();
  };
  /// The rigid motion of the same momenta, with inertia and angular momentum about the centroid.
  struct RigidMotion {
    Vec3 centroid, velocity, turn;  // m, m/s, rad/s
    Mat3 inertia;                   // kg m²
    Vec3 angular;                   // N m s
    double kinetic;                 // J
    RigidMotion(const Sums& sums, const Vec3& about);
    Vec3 at(const Vec3& position) const { return velocity + turn.cross(position - centroid); }
  };
  struct Group {
    int begin, end;  // into bodies_
    Vec3 about;      // m
    Sums at_start;
  };
  std::span<const int> bodies_of(const Group& group) const {
    return std::span(bodies_).subspan(group.begin, group.end - group.begin);
  }
  static bool is_alone(const Group& group) { return group.end - group.begin == 1; }
  bool deforms_alone(const Group& group) const;
  /// What a node does beside a rigid motion [m/s].
  Vec3 beside(const RigidMotion& motion, int node) const {
    return set_.nodes.velocity[node] - motion.at(set_.nodes.position[node]);
  }
  void find_groups(const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes);
  /// Returns what kinetic energy bodies gain by it [J].
  double keep_angular_momentum(const Group& group);
  void calm(const Group& group);
  /// Velocities become those of the motion, further turned at a rate [rad/s], and `share` of what they are beside it.
  void set_velocities(const Group& group, const RigidMotion& motion, const Vec3& further, double share);
  Sums sums(std::span<const int> bodies, const Vec3& about) const;
  void add(const RigidBody& body, const Vec3& about, Sums& sums) const;
  void add(const Element& element, const Vec3& about, Sums& sums) const;

  BodySet& set_;
  DisjointSets together_;
  std::vector<char> is_held_;  // a body that is the first of those together: one of them touches what does not fly
  std::vector<char> flies_;    // a body
  std::vector<int> bodies_;    // group by group
  std::vector<Group> groups_;
  std::vector<Vec3> beside_;  // m/s, a node of a body that deforms and flies alone, at the start of the step
};

}  // namespace talus
