#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/broad_phase.hpp"

namespace talus {

enum class PointKind : std::uint8_t { facing, vertex, edge, meeting };

/// A contact point as geometry gives it: no law, no history.
struct FoundPoint {
  std::uint64_t key;
  std::uint64_t family;  ///< points that lie on the same two patches, or on the same two creases
  PointKind kind;
  std::array<int, 2> facets;  ///< of the first body and of the second
  std::array<int, 2> bodies;  ///< once the stencil is closed
  std::array<int, 2> patches;
  int node;                      ///< whose contact it is; −1: two edges'
  int along = -1;                ///< facing facets: which of the two it slides along; −1: halfway between them
  int joint;                     ///< −1: the pair's
  Vec3 normal = Vec3::Zero();    ///< from the second body to the first
  Vec3 position = Vec3::Zero();  ///< on the first
  double gap, area;              ///< m; m², 0 without an area
  int stencil_begin, stencil_end;
  bool dropped;
};

/// Points and their stencils. `covered` are the keys of vertices whose contact another vertex at the same place stands
/// for.
struct FoundPoints {
  struct Covered {
    std::uint64_t key;
    int node, facet;  ///< the vertex, the facet it is on
    Vec3 normal;      ///< from the facet to the vertex's body
  };
  std::vector<FoundPoint> points;
  std::vector<int> nodes;
  std::vector<double> weights;
  std::vector<Covered> covered;

  void clear();
  /// Ends the stencil that began at `point.stencil_begin`: drops what rounding left, makes the weights add up to +1
  /// over the first body's nodes and −1 over the second's, and measures gap and position.
  void close_stencil(FoundPoint& point, const ContactFeatures& features, std::span<const Vec3> x, int nodes_of_first);

  /// Adds a point with the stencil of a vertex on a facet; `shares` are the place's on the facet's nodes.
  void add_vertex(FoundPoint point, const std::array<int, 3>& facet_nodes, const std::array<double, 3>& shares,
                  bool node_is_first, const ContactFeatures& features, std::span<const Vec3> x);
  /// Adds a point with the stencil of a place between two nodes of each body, at the shares s and t of the way; a place
  /// at a node is between this and itself.
  void add_between(FoundPoint point, const std::array<int, 2>& of_first, double s, const std::array<int, 2>& of_second,
                   double t, const ContactFeatures& features, std::span<const Vec3> x);
};

/// |a×b|² of |a|²|b|²: below it the direction across two edges is not that of their cross product alone.
inline constexpr double nearly_parallel = 1e-3;

/// Degrees within which one surface goes on as another, and two pushes are along one direction.
inline constexpr double flush_angle = 10.0;

/// Of one depth: another that is no more than this share of it was certainly the way in.
inline constexpr double clearly_less = 0.5;

class ContactMemory;

/// What the searches look at: the surfaces as they are at the start of the step.
struct StepGeometry {
  const ContactFeatures& features;
  const BroadPhase& broad;
  std::span<const Vec3> x;
  std::span<const Vec3> normals;        ///< a facet; up to date for those in the pairs that are searched
  std::span<const double> penetration;  ///< m, a body: the deepest of the last step
  std::span<const double> widths;       ///< m, a body: where it is thinnest
  std::span<const double> first_areas;  ///< m², a facet: before any body deformed
  const ContactSettings& settings;
  double reach;
  std::span<const char> moved;  ///< a body: it took part in a step and was not fixed
  const ContactMemory& memory;

  /// Whether one of the two could move before: they cannot be deep in each other all of a sudden.
  bool begun(int body_a, int body_b) const { return moved[body_a] || moved[body_b]; }
  /// The deepest that two bodies lay in each other at the end of the last step. [m]
  double deepest(int body_a, int body_b) const { return std::max(penetration[body_a], penetration[body_b]); }
  /// How near each other features of two bodies are in one place. [m]
  double rim(int body_a, int body_b) const;
  /// Is what lies on `body`, by `distance` [m] on this side of a convex crease, left to the facet beyond, with the
  /// normal `beyond`? It is if that is next to nothing, or no more than what `other` may lie in `body` along that
  /// normal while a third one holds either: two that this one carries slide past each other there.
  bool within_rim(double distance, int body, int other, const Vec3& beyond) const;
  double widest_rim(int body_a, int body_b) const;  ///< nothing farther from a crease is within its rim [m]
  /// How deep two bodies' features can lie in each other: what the last step left and this one may add, and never more
  /// than the settings allow, nor than the middle of the thinner: beyond it a feature belongs to the far side. A
  /// feature that seems to lie deeper came past from outside, beside the other body. [m]
  double depth(int body_a, int body_b) const;
  /// Do all these points of body `other`, of which some lie below a facet, lie nearer to a convex crease of it than the
  /// deepest is deep, or within its rim? What slides along the facet beyond has come past the crease from outside,
  /// however far it reaches behind this one; but not what is deeper still behind the facet beyond, which leaves it to
  /// this one. Behind a ridge of less than 90° nothing is as deep as it is far from the crease: there it has come past
  /// if it is clearly less deep behind the facet beyond. Only creases count whose facet beyond has a normal that
  /// `counts`.
  template <class Counts>
  bool came_past_a_crease(int facet, std::span<const Vec3> points, int other, const Counts& counts) const;
  /// So deep is too deep for rounding. [m]
  double seen_depth(int body_a, int body_b) const;
  /// Joint that both facets carry, or −1.
  int common_joint(int facet_a, int facet_b) const;
  Vec3 fresh_normal(int facet) const;  ///< of any facet
};

template <class Counts>
bool StepGeometry::came_past_a_crease(int facet, std::span<const Vec3> points, int other, const Counts& counts) const {
  const ContactFacet& f = features.facets[facet];
  const Vec3 centre = (x[f.nodes[0]] + x[f.nodes[1]] + x[f.nodes[2]]) / 3;
  const auto depth_below = [&](const Vec3& normal, int node, const Vec3& p) { return normal.dot(x[node] - p); };
  for (const int node : f.nodes)
    for (const int beyond : features.facets_at(node)) {
      if (features.facets[beyond].patch == f.patch) continue;
      const Vec3 n = fresh_normal(beyond);
      if (!(depth_below(n, node, centre) > rim(f.body, other)) || !counts(n)) continue;
      const double cosine = n.dot(normals[facet]), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
      double width = 0, deepest = 0, below = 0;
      for (const Vec3& p : points) {
        const double here = depth_below(normals[facet], node, p), there = depth_below(n, node, p);
        deepest = std::max(deepest, here);
        below = std::max(below, there);
        width = std::max(width, (there - here * cosine) / sine);
      }
      const bool at_a_sharp_ridge = cosine < 0 && below <= clearly_less * deepest;
      const bool beside = at_a_sharp_ridge || (width < deepest && below <= deepest);
      if (beside || within_rim(below, f.body, other, n)) return true;
    }
  return false;
}

/// Sine of the angle by which normals may leave a feature's cone.
double cone_tolerance(const ContactSettings& settings);

/// Keys are made of feature numbers alone: the same features have the same key in every step, and no two share one.
std::uint64_t vertex_key(int node, int patch);
std::uint64_t crossing_key(const ContactFeatures& features, int edge_a, int patch_a, int edge_b, int patch_b);
std::uint64_t edge_key(int edge_a, int edge_b);
/// The edges of a point where two cross.
std::array<int, 2> edges_of(const FoundPoint& crossing);
std::uint64_t patch_family(int patch_a, int patch_b);
std::uint64_t crease_family(int crease_a, int crease_b);

/// The paper's way, the yardstick: a common plane for each pair of facets, and the contact points that this plane alone
/// gives. Nothing is known of the facets around.
class FacetWiseSearch {
 public:
  void find(const StepGeometry& step, std::span<const FacetPair> pairs, FoundPoints& found);

 private:
  struct Touch {
    std::uint64_t key;
    int order;
    FacetPair facets;
    Vec3 normal;
    double gap, area;
    int node;                      // −1: two edges cross
    std::array<int, 2> edges;      // of a crossing
    std::array<double, 3> shares;  // of the facet's nodes, or of both edges
  };
  void touch(const StepGeometry& step, const FacetPair& pair);
  void vertices_on(const StepGeometry& step, const FacetPair& pair, bool node_is_first, const Vec3& n);
  void crossings(const StepGeometry& step, const FacetPair& pair, const Vec3& n);
  void keep(const StepGeometry& step, Touch touch);
  std::vector<Touch> touches_;
};

/// Facets that face each other: the corners of their overlaps, merged where the mesh alone divides them.
class FacingSearch {
 public:
  void find(const StepGeometry& step, std::span<const FacetPair> pairs, FoundPoints& found);

 private:
  struct Corner {
    std::uint64_t key;
    FacetPair facets;
    double weight;  // m²
    std::array<double, 6> shares;
    Vec3 normal;
    int along = -1;  // as of a found point
  };
  void overlap(const StepGeometry& step, const FacetPair& pair, FoundPoints& found);
  void place_corners(const StepGeometry& step, std::size_t first);
  void name(const StepGeometry& step, Corner& corner, FoundPoints& found);
  void merge(const StepGeometry& step, FoundPoints& found);
  std::vector<Corner> corners_;
  std::array<std::vector<Vec3>, 2> places_;            // m, of the corners of one overlap, on both bodies
  std::vector<std::pair<std::uint64_t, int>> by_key_;  // keys and numbers of corners_, sorted
};

/// Vertices on facets, each once for every patch. Points of facing facets must be there already.
class VertexSearch {
 public:
  void find(const StepGeometry& step, std::span<const FacetPair> pairs, FoundPoints& found);
  /// Whether the last search, or facing facets before it, found the vertex on the patch; even if the contact was false.
  bool has(int node, int patch) const;

 private:
  struct Touch {
    std::uint64_t key;
    int node, facet;
    bool node_is_first;
    std::array<double, 3> shares;
    double inside;  // the smallest share: of a patch's facets the one with the largest is the one below
  };
  struct Held {
    int node;
    int point;    // −1: covered
    int body;     // that holds it
    Vec3 normal;  // towards the node's body
  };
  void touch(const StepGeometry& step, int node, int facet, bool node_is_first);
  void add(const StepGeometry& step, const Touch& touch, FoundPoints& found);
  void drop_false(const StepGeometry& step, FoundPoints& found);
  void drop_doubled(const StepGeometry& step, FoundPoints& found);
  bool beyond_rim(const StepGeometry& step, const FoundPoint& p, const Held& h, std::span<const Held> group,
                  const FoundPoints& found) const;
  bool deeper(const StepGeometry& step, const FoundPoint& p, const Held& h, std::span<const Held> group,
              const FoundPoints& found) const;

  std::vector<Touch> touches_;
  std::vector<std::uint64_t> taken_;
  std::vector<Held> held_;
};

/// Crossing convex edges. Points of facing facets and vertices must be there already.
class EdgeSearch {
 public:
  void find(const StepGeometry& step, std::span<const FacetPair> pairs, const VertexSearch& vertices,
            FoundPoints& found);

 private:
  void cross(const StepGeometry& step, int edge_a, int edge_b, const VertexSearch& vertices, FoundPoints& found);
  bool found_before(const FoundPoint& p, double from_end, double near, const StepGeometry& step,
                    const FoundPoints& found) const;
};

}  // namespace talus
