#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_features.hpp"

namespace talus {

/// Which features touch. Vertex–vertex contact is also that of a vertex with an edge, and of edges along each other:
/// there no feature has a normal of its own.
enum class PointKind : std::uint8_t { face_face, vertex_face, edge_edge, vertex_vertex };

/// What a corner of face–face contact slides along: the first body's facet, the second's, both edges that cross there,
/// or the plane halfway between the facets.
enum class Glide : std::uint8_t { first_facet, second_facet, edges, halfway };

/// A contact point as geometry gives it: no law, no history.
struct FoundPoint {
  std::uint64_t key;
  std::uint64_t family;  ///< points on the same two smooth faces, or on the same two sharp edges
  PointKind kind;
  std::array<int, 2> facets;  ///< of the first body and of the second
  std::array<int, 2> bodies;  ///< once the stencil is closed
  std::array<int, 2> smooth_faces;
  int node;                      ///< whose contact it is; −1: two edges'
  Glide glide = Glide::halfway;  ///< of a corner of face–face contact
  int joint;                     ///< −1: the pair's
  Vec3 normal = Vec3::Zero();    ///< from the second body to the first
  Vec3 position = Vec3::Zero();  ///< on the first
  double gap, area;              ///< m; m², 0 without an area
  int stencil_begin, stencil_end;
  bool dropped;
  bool is_of_end;  ///< its normal is that which its features have at the end of the step
  bool is_beside;  ///< a vertex that is not over the face yet, but may come to it along the other side of a valley
};

/// Points and their stencils. `covered` are the keys of vertices whose contact another vertex at the same place stands
/// for.
struct FoundPoints {
  /// `least`: nodes of less weight take no part in a stencil.
  explicit FoundPoints(double least) : least_weight(least) {}

  struct Covered {
    std::uint64_t key;
    int node, facet;  ///< the vertex, the facet it is on
    Vec3 normal;      ///< from the facet to the vertex's body
  };
  std::vector<FoundPoint> points;
  std::vector<int> nodes;
  std::vector<double> weights;
  std::vector<Covered> covered;
  double least_weight;

  void clear();
  /// Ends the stencil that began at `point.stencil_begin`: leaves out nodes of hardly any weight, makes the weights add
  /// up to +1 over the first body's nodes and −1 over the second's, and measures gap and position.
  void close_stencil(FoundPoint& point, const ContactFeatures& features, std::span<const Vec3> x, int nodes_of_first);

  /// Of a point of these, from its place on the second body to that on the first. [m]
  template <class Positions>
  Vec3 difference(const FoundPoint& point, const Positions& at) const {
    const Vec3 origin = at(nodes[point.stencil_begin]);
    Vec3 sum = Vec3::Zero();
    for (int i = point.stencil_begin; i < point.stencil_end; ++i) sum += weights[i] * (at(nodes[i]) - origin);
    return sum;
  }
  /// Adds a point of others, which were found at the end of the step, as it is at the start, at x [m]; for one with the
  /// same key that was dropped, if there is one. Points are sorted by key, and remain so.
  void add_of_end(const FoundPoints& others, const FoundPoint& point, std::span<const Vec3> x);

  /// Adds a point with the stencil of a vertex on a facet, at the barycentric coordinates `at` of the facet's nodes.
  void add_vertex(FoundPoint point, const std::array<int, 3>& facet_nodes, const std::array<double, 3>& at,
                  bool node_is_first, const ContactFeatures& features, std::span<const Vec3> x);
  /// Adds a point with the stencil of a place between two nodes of each body, at the fractions s and t from the first
  /// node to the second; a place at a node is between this and itself.
  void add_between(FoundPoint point, const std::array<int, 2>& of_first, double s, const std::array<int, 2>& of_second,
                   double t, const ContactFeatures& features, std::span<const Vec3> x);
};

/// Keys are made of feature numbers alone: the same features have the same key in every step, and no two contacts have
/// the same.
std::uint64_t vertex_key(int node, int smooth_face);
std::uint64_t crossing_key(const ContactFeatures& features, int edge_a, int face_a, int edge_b, int face_b);
std::uint64_t edge_key(int edge_a, int edge_b);
/// The edges of a point where two cross.
std::array<int, 2> edges_of(const FoundPoint& crossing);
std::uint64_t face_family(int face_a, int face_b);
std::uint64_t sharp_edge_family(int sharp_edge_a, int sharp_edge_b);

}  // namespace talus
