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
  std::array<int, 3> edges;       ///< opposite to each node
  std::array<bool, 3> owns_node;  ///< every node and every edge is owned by one of its facets, so that a search over
  std::array<bool, 3> owns_edge;  ///< pairs of facets comes upon each pair of features once
  int body;
  int smooth_face;
  int joint;
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
  explicit ContactFeatures(std::span<const ContactBody> bodies);

  std::vector<ContactFacet> facets;
  std::vector<ContactEdge> edges;
  std::vector<int> facet_begin;  ///< of body b: facet_begin[b] … facet_begin[b + 1]
  std::vector<char> corner;      ///< a node
  std::vector<char> movable;     ///< a node
  std::vector<int> handle;       ///< a node: itself, or the first of its body if all of that moves together

  /// A body's nodes may move from now on, or may not.
  void set_movable(const ContactBody& body, bool movable_now);

  int node_count() const { return static_cast<int>(corner.size()); }
  int body_of(int node) const { return body_of_[node]; }
  /// Whether the node's body is a single one, of one handle.
  bool moves_as_one(int node) const { return single_[body_of_[node]]; }
  std::span<const int> ring(int node) const { return row(ring_begin_, ring_, node); }
  std::span<const int> facets_at(int node) const { return row(facets_at_begin_, facets_at_, node); }

 private:
  static std::span<const int> row(const std::vector<int>& begin, const std::vector<int>& items, int i) {
    return {items.data() + begin[i], items.data() + begin[i + 1]};
  }
  void add_body(const ContactBody& body, int number);
  void link_nodes(std::span<const ContactBody> bodies);

  std::vector<int> body_of_;  // a node
  std::vector<char> single_;  // a body
  std::vector<int> ring_begin_, ring_, facets_at_begin_, facets_at_;
  int smooth_face_count_ = 0, sharp_edge_count_ = 0;
};

}  // namespace talus
