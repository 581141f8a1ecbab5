#include "contact/contact_features.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "mesh/surface.hpp"

namespace talus {

double facet_area(const ContactFacet& facet, std::span<const Vec3> x) {
  const Vec3 u = x[facet.nodes[1]] - x[facet.nodes[0]], v = x[facet.nodes[2]] - x[facet.nodes[0]];
  return u.cross(v).norm() / 2;
}

ContactFeatures::ContactFeatures(std::span<const ContactBody> bodies) {
  int nodes = 0;
  for (const ContactBody& b : bodies) nodes = std::max(nodes, b.first_node + static_cast<int>(b.surface->ring.size()));
  corner.assign(nodes, 0);
  movable.assign(nodes, 0);
  handle.resize(nodes);
  body_of_.resize(nodes);
  for (int b = 0; b < static_cast<int>(bodies.size()); ++b) add_body(bodies[b], b);
  facet_begin.push_back(static_cast<int>(facets.size()));
  link_nodes(bodies);
}

void ContactFeatures::add_body(const ContactBody& body, int number) {
  const Surface& s = *body.surface;
  const int first_facet = static_cast<int>(facets.size()), first_edge = static_cast<int>(edges.size());
  facet_begin.push_back(first_facet);
  single_.push_back(body.single_body);

  std::vector<std::pair<int, int>> sharp_edges;
  for (const SurfaceEdge& e : s.edges) {
    sharp_edges.push_back(std::minmax({s.smooth_face[e.triangles[0]], s.smooth_face[e.triangles[1]]}));
  }
  std::vector<std::pair<int, int>> distinct = sharp_edges;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());

  for (std::size_t i = 0; i < s.edges.size(); ++i) {
    const SurfaceEdge& e = s.edges[i];
    ContactEdge edge;
    const auto place = std::lower_bound(distinct.begin(), distinct.end(), sharp_edges[i]) - distinct.begin();
    edge.sharp_edge = sharp_edge_count_ + static_cast<int>(place);
    edge.is_sharp = sharp_edges[i].first != sharp_edges[i].second;
    for (int k = 0; k < 2; ++k) {
      const SurfaceTriangle& t = s.triangles[e.triangles[k]];
      const auto& opposite = s.triangle_edges[e.triangles[k]];
      const auto corner_of = std::find(opposite.begin(), opposite.end(), static_cast<int>(i)) - opposite.begin();
      edge.nodes[k] = body.first_node + e.nodes[k];
      edge.facets[k] = first_facet + e.triangles[k];
      edge.opposite[k] = body.first_node + t.nodes[corner_of];
    }
    edges.push_back(edge);
  }

  std::vector<char> owned(s.ring.size(), 0);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    ContactFacet f;
    for (int k = 0; k < 3; ++k) {
      const int node = s.triangles[t].nodes[k], edge = s.triangle_edges[t][k];
      f.nodes[k] = body.first_node + node;
      f.edges[k] = first_edge + edge;
      f.owns_node[k] = !owned[node];
      f.owns_edge[k] = s.edges[edge].triangles[0] == static_cast<int>(t);
      owned[node] = 1;
    }
    f.body = number;
    f.smooth_face = smooth_face_count_ + s.smooth_face[t];
    f.joint = s.triangles[t].joint;
    facets.push_back(f);
  }
  for (int i = 0; i < static_cast<int>(s.ring.size()); ++i) {
    corner[body.first_node + i] = s.corner[i];
    handle[body.first_node + i] = body.single_body ? body.first_node : body.first_node + i;
    body_of_[body.first_node + i] = number;
  }
  set_movable(body, !body.fixed);
  smooth_face_count_ += s.smooth_face_count;
  sharp_edge_count_ += static_cast<int>(distinct.size());
}

void ContactFeatures::set_movable(const ContactBody& body, bool movable_now) {
  std::fill_n(movable.begin() + body.first_node, body.surface->ring.size(), movable_now);
}

void ContactFeatures::link_nodes(std::span<const ContactBody> bodies) {
  std::vector<std::vector<int>> ring(node_count()), at(node_count());
  for (const ContactBody& b : bodies) {
    for (std::size_t i = 0; i < b.surface->ring.size(); ++i) {
      for (int n : b.surface->ring[i]) ring[b.first_node + i].push_back(b.first_node + n);
    }
  }
  for (int f = 0; f < static_cast<int>(facets.size()); ++f) {
    for (int n : facets[f].nodes) at[n].push_back(f);
  }
  const auto flatten = [](const std::vector<std::vector<int>>& rows, std::vector<int>& begin, std::vector<int>& items) {
    begin.push_back(0);
    for (const auto& r : rows) {
      items.insert(items.end(), r.begin(), r.end());
      begin.push_back(static_cast<int>(items.size()));
    }
  };
  flatten(ring, ring_begin_, ring_);
  flatten(at, facets_at_begin_, facets_at_);
}

}  // namespace talus
