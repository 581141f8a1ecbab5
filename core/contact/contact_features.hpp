#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "contact/contact_body.hpp"

namespace talus {

/// A surface triangle of any body, under numbers that no two bodies share.
struct ContactFacet {
  std::array<int, 3> nodes;
  std::array<int, 3> edges;  ///< opposite to each node
  int body;
  int smooth_face;
  int joint;
  int face;  ///< that it is part of
};

/// What is searched as one: a plane face of a single, convex body; else a single facet.
struct ContactFace {
  int body;
  int smooth_face;
  int facet;  ///< the largest of its facets, whose plane is that of all
};

/// With nodes at `x` [m]. [m²]
double facet_area(const ContactFacet& facet, std::span<const Vec3> x);

struct ContactEdge {
  std::array<int, 2> nodes;
  std::array<int, 2> facets;
  std::array<int, 2> opposite;  ///< the third node of each facet
  int sharp_edge;               ///< edges between the same two smooth faces are one sharp edge
  bool is_sharp;                ///< its two faces are different ones; else it is an edge of the mesh alone
};

/// The surface features of all bodies, numbered through. Nodes carry their global numbers.
class ContactFeatures {
 public:
  /// `facets_alone`: every facet is a face of its own.
  explicit ContactFeatures(std::span<const ContactBody> bodies, bool facets_alone = false);

  std::vector<ContactFacet> facets;
  std::vector<ContactFace> faces;
  std::vector<ContactEdge> edges;
  std::vector<int> facet_begin;  ///< of body b: facet_begin[b] … facet_begin[b + 1]
  std::vector<int> face_begin;   ///< as facet_begin
  std::vector<char> corner;      ///< a node
  std::vector<char> movable;     ///< a node
  std::vector<int> handle;       ///< a node: itself, or the first of its body if all of that moves together

  /// A body's nodes may move from now on, or may not.
  void set_movable(const ContactBody& body, bool movable_now);

  int node_count() const { return static_cast<int>(corner.size()); }
  int body_of(int node) const { return body_of_[node]; }
  /// Whether a body remains as it is but for rotation and affine deformation: it is single, or fixed and was never
  /// released.
  bool keeps_shape(int body) const { return keeps_shape_[body]; }
  /// Whether a body was convex before it deformed; and whether it remains so.
  bool was_convex(int body) const { return convex_[body]; }
  bool is_convex(int body) const { return convex_[body] && keeps_shape_[body]; }
  /// One face in each plane that has the whole body on one side, as long as the body keeps its shape: of a convex body
  /// every face, of another those that are also its convex hull's.
  std::span<const int> supporting_faces(int body) const { return row(supporting_begin_, supporting_, body); }
  /// Whether the node's body is a single one, of one handle.
  bool moves_as_one(int node) const { return single_[body_of_[node]]; }
  std::span<const int> ring(int node) const { return row(ring_begin_, ring_, node); }
  /// Nodes and edges at a node, but for what lies inside a face, and one facet of every face there.
  std::span<const int> edges_at(int node) const { return row(edges_at_begin_, edges_at_, node); }
  std::span<const int> facets_at(int node) const { return row(facets_at_begin_, facets_at_, node); }

  /// The facets of a face, the largest first.
  std::span<const int> facets_of(int face) const { return row(facets_of_begin_, facets_of_, face); }
  /// The nodes around a face, counter-clockwise as seen from outside, …
  std::span<const int> outline(int face) const { return row(outline_begin_, outline_, face); }
  /// … and the edges from each to the next.
  std::span<const int> sides(int face) const { return row(outline_begin_, sides_, face); }
  /// The facet on the other side of an edge of a face.
  int across(int edge, int face) const {
    const auto& sides = edges[edge].facets;
    return facets[sides[0]].face == face ? sides[1] : sides[0];
  }
  /// Every node where three faces meet and every edge between faces is owned by one of these, so that a search over
  /// pairs of faces comes upon each pair of features once.
  std::span<const int> owned_nodes(int face) const { return row(owned_nodes_begin_, owned_nodes_, face); }
  std::span<const int> owned_edges(int face) const { return row(owned_edges_begin_, owned_edges_, face); }

 private:
  static std::span<const int> row(const std::vector<int>& begin, const std::vector<int>& items, int i) {
    return {items.data() + begin[i], items.data() + begin[i + 1]};
  }
  void add_body(const ContactBody& body, int number);
  void add_faces(const ContactBody& body, int number, bool facets_alone);
  void link_nodes();

  std::vector<int> body_of_;                         // a node
  std::vector<char> single_, convex_, keeps_shape_;  // a body
  std::vector<int> ring_begin_, ring_, edges_at_begin_, edges_at_, facets_at_begin_, facets_at_;
  std::vector<int> supporting_begin_ = {0}, supporting_;
  std::vector<int> facets_of_begin_ = {0}, facets_of_, outline_begin_ = {0}, outline_, sides_;
  std::vector<int> owned_nodes_begin_ = {0}, owned_nodes_, owned_edges_begin_ = {0}, owned_edges_;
  int smooth_face_count_ = 0, sharp_edge_count_ = 0;
};

}  // namespace talus
