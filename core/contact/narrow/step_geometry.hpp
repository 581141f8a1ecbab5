#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>

#include "base/units.hpp"
#include "contact/broad/broad_phase.hpp"
#include "contact/found_point.hpp"
#include "contact/narrow/feature_shapes.hpp"

namespace talus {

class ContactMemory;

/// What the searches for contact points look at: the surfaces as they are at the start of the step, how deep bodies lie
/// in each other, and what follows from that for where one feature ends and the next begins.
struct StepGeometry {
  const ContactFeatures& features;
  const BroadPhase& broad;
  std::span<const Vec3> x;              ///< m, a node
  std::span<const double> penetration;  ///< m, a body: the deepest of the last step
  std::span<const double> widths;       ///< m, a body: where it is thinnest
  std::span<const double> first_areas;  ///< m², a facet: before any body deformed
  const ContactTolerances& tolerances;
  const Reach& reach;           ///< the gap up to which contacts matter
  std::span<const char> moved;  ///< a body: it took part in a step and was not fixed
  const ContactMemory& memory;
  FeatureShapes& shapes;
  /// Sine of the angle by which normals may leave the normal cone of a feature.
  double cone_tolerance = std::sin(radians(tolerances.face_face_angle));
  /// Cosine of the largest angle between the normal of one facet and the opposite of another's in face–face contact.
  double face_face_cosine = std::cos(radians(tolerances.face_face_angle));
  /// Cosine of the largest angle between normals that are along one direction.
  double flush_cosine = std::cos(radians(tolerances.flush_angle));
  ContactWork& work;  ///< where the searches count what they come up against, …

  /// … by one, whoever else counts at the same time.
  static void count(long& what) { std::atomic_ref(what).fetch_add(1, std::memory_order_relaxed); }

  /// Whether one of the two could move before: only then is it known how deep they may be in each other.
  bool have_moved(int body_a, int body_b) const { return moved[body_a] || moved[body_b]; }
  /// The deepest that two bodies lay in each other at the end of the last step. [m]
  double deepest(int body_a, int body_b) const { return std::max(penetration[body_a], penetration[body_b]); }
  /// How near features of two bodies must be to count as being in one place. It grows with how deep the two lay in each
  /// other. Features in vertex–vertex contact are rounded by as much. [m]
  double edge_tolerance(int body_a, int body_b) const;
  /// No place on a facet that is farther than this from its sharp edge counts as at the edge. [m]
  double largest_edge_tolerance(int body_a, int body_b) const;
  /// A place on a facet of `body` is `distance` [m] from a convex sharp edge; the facet across that edge has the normal
  /// `across`. Whether the place counts as past the edge, so that the facet across it has the contact with `other`, if
  /// any. It does where the distance is next to nothing. It also does where a third body held either of the two along
  /// `across` in the last step, and the distance is no more than a few times as deep as they lay in it: blocks that lie
  /// on a third sink into it, their faces are out of line by about as much, and they must slide past each other.
  bool within_edge_tolerance(double distance, int body, int other, const Vec3& across) const;
  /// The same, where the distance is next to nothing or no more than so many `times` as deep as they lay in a third.
  bool sank_over_edge(double distance, double times, int body, int other, const Vec3& across) const;
  /// How far places of `other` may lie past a convex sharp edge of `body`, the facet across which has the normal
  /// `across`, and yet be held by the facet on this side: a few times as much deeper as `other` lay in what pushed it
  /// back over the edge in the last step than in what pushed it on. A block on a floor has sunk below the foot of a
  /// wall that stands there, too. [m]
  double sunk_past_edge(int other, int body, const Vec3& across) const;
  /// How deep features of two bodies can lie in each other. At most as deep as the tolerances say, and as half the
  /// width of the thinner body, for beyond its middle a feature belongs to its far side. Once they have moved, also no
  /// deeper than this step can add to what the last one left: a feature that seems to lie deeper has passed beside the
  /// other body. [m]
  double depth(int body_a, int body_b) const;
  /// How far apart a corner and an edge in vertex–vertex contact may be. [m]
  double farthest_cores(int body_a, int body_b) const {
    return reach(body_a, body_b) + 3 * tolerances.deepest_core * edge_tolerance(body_a, body_b);
  }
  /// Facets that are farther apart than this, or that lie deeper behind each other, do not touch. [m]
  double search_distance(int body_a, int body_b) const {
    return std::max(depth(body_a, body_b), farthest_cores(body_a, body_b));
  }
  /// Penetration that is certainly more than rounding. [m]
  double noticeable_depth(int body_a, int body_b) const;
  /// Of `points` of the body `other` some lie below a face. Whether they came there from outside, past a convex sharp
  /// edge of the face: then the contact is false. At an edge whose facet across has the normal `across`, and
  /// `counts(across)` holds, they did so if none is deeper below the facet across than the two sank over the edge. They
  /// also did, where `least_deep()` does not say that the bodies are less deep in no other direction, if
  /// - none is deeper below the facet across than the edge tolerance, or
  /// - they are less wide, from the edge, than the deepest is deep, and none is deeper below the facet across: what
  ///   slides along that one, however far it reaches below this one, or
  /// - the edge is sharper than 90° and they are clearly less deep below the facet across. (There the width says
  ///   nothing: what is below both facets is always wider than deep.)
  template <class Counts, class LeastDeep>
  bool came_past_sharp_edge(int face, std::span<const Vec3> points, int other, const Counts& counts,
                            const LeastDeep& least_deep) const;
  /// Joint that both facets carry, or −1.
  int common_joint(int facet_a, int facet_b) const;
  /// Of a facet: that of its face.
  const Vec3& normal(int facet) const { return shapes.normal(features.facets[facet].face); }
  const Vec3& face_normal(int face) const { return shapes.normal(face); }
  Vec3 centre(int face) const {
    const auto nodes = features.outline(face);
    Vec3 sum = x[nodes[0]];
    for (const int node : nodes.subspan(1)) sum += x[node];
    return sum / static_cast<double>(nodes.size());
  }
};

template <class Counts, class LeastDeep>
bool StepGeometry::came_past_sharp_edge(int face, std::span<const Vec3> points, int other, const Counts& counts,
                                        const LeastDeep& least_deep) const {
  const ContactFace& f = features.faces[face];
  const Vec3 centre = this->centre(face);
  const auto depth_below = [&](const Vec3& normal, int node, const Vec3& p) { return normal.dot(x[node] - p); };
  for (const int node : features.outline(face))
    for (const int across : features.facets_at(node)) {
      if (features.facets[across].smooth_face == f.smooth_face) continue;
      const Vec3& n = normal(across);
      if (!(depth_below(n, node, centre) > edge_tolerance(f.body, other)) || !counts(n)) continue;
      const auto lies_below = [&](int m) { return depth_below(n, node, x[m]) > -edge_tolerance(f.body, other); };
      if (!std::ranges::all_of(features.outline(face), lies_below)) continue;
      const double cosine = n.dot(face_normal(face)), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
      double width = 0, deepest = 0, below = 0;
      for (const Vec3& p : points) {
        const double here = depth_below(face_normal(face), node, p), there = depth_below(n, node, p);
        deepest = std::max(deepest, here);
        below = std::max(below, there);
        width = std::max(width, (there - here * cosine) / sine);
      }
      const bool past_acute_edge = cosine < 0 && below <= tolerances.clearly_shallower * deepest;
      const bool beside = past_acute_edge || (width < deepest && below <= deepest);
      const bool came_past = beside || within_edge_tolerance(below, f.body, other, n);
      if (came_past && (sank_over_edge(below, 1, f.body, other, n) || !least_deep())) return true;
    }
  return false;
}

}  // namespace talus
