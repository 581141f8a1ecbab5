#include "contact/contact_features.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "mesh/surface.hpp"

namespace talus {

double facet_area(const ContactFacet& facet, std::span<const Vec3> x) {
  const Vec3 u = x[facet.nodes[1]] - x[facet.nodes[0]], v = x[facet.nodes[2]] - x[facet.nodes[0]];
  return u.cross(v).norm() / 2;
}

ContactFeatures::ContactFeatures(std::span<const ContactBody> bodies, bool facets_alone) {
  int nodes = 0;
  for (const ContactBody& b : bodies) nodes = std::max(nodes, b.first_node + static_cast<int>(b.surface->ring.size()));
  corner.assign(nodes, 0);
  movable.assign(nodes, 0);
  handle.resize(nodes);
  body_of_.resize(nodes);
  for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
    add_body(bodies[b], b);
    add_faces(bodies[b], b, facets_alone);
  }

  facet_begin.push_back(static_cast<int>(facets.size()));
  face_begin.push_back(static_cast<int>(faces.size()));
  link_nodes();
}

void ContactFeatures::add_body(const ContactBody& body, int number) {
  const Surface& s = *body.surface;
  const int first_facet = static_cast<int>(facets.size()), first_edge = static_cast<int>(edges.size());
  facet_begin.push_back(first_facet);
  single_.push_back(body.single_body);
  convex_.push_back(s.is_convex);
  keeps_shape_.push_back(body.single_body || body.fixed);

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

  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    ContactFacet f;
    for (int k = 0; k < 3; ++k) {
      const int node = s.triangles[t].nodes[k], edge = s.triangle_edges[t][k];
      f.nodes[k] = body.first_node + node;
      f.edges[k] = first_edge + edge;
    }
    f.body = number;
    f.smooth_face = smooth_face_count_ + s.smooth_face[t];
    f.joint = s.triangles[t].joint;
    f.face = -1;
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

void ContactFeatures::add_faces(const ContactBody& body, int number, bool facets_alone) {
  const Surface& s = *body.surface;
  const int first_facet = facet_begin.back();
  face_begin.push_back(static_cast<int>(faces.size()));
  const auto end_row = [](std::vector<int>& begin, const std::vector<int>& items) {
    begin.push_back(static_cast<int>(items.size()));
  };
  const auto add = [&](std::span<const int> triangles, std::span<const int> outline) {
    const int face = static_cast<int>(faces.size()), first = first_facet + triangles[0];
    faces.push_back({number, facets[first].smooth_face, first});
    for (const int t : triangles) {
      facets[first_facet + t].face = face;
      facets_of_.push_back(first_facet + t);
    }
    for (const int node : outline) outline_.push_back(body.first_node + node);
    end_row(facets_of_begin_, facets_of_);
    end_row(outline_begin_, outline_);
  };
  if (body.single_body && s.is_convex && !facets_alone) {
    for (const PlaneFace& face : s.faces) add(face.triangles, face.outline);
  } else {
    for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) add({&t, 1}, s.triangles[t].nodes);
  }
  for (const int face : s.supporting) supporting_.push_back(facets[first_facet + s.faces[face].triangles[0]].face);
  end_row(supporting_begin_, supporting_);

  // Where only two faces meet, a node lies amid a straight edge: no vertex.
  std::vector<int> faces_at(s.ring.size(), 0);
  for (int i = outline_begin_[face_begin.back()]; i < outline_begin_.back(); ++i)
    ++faces_at[outline_[i] - body.first_node];
  std::vector<char> owned(s.ring.size(), 0);
  for (int face = face_begin.back(); face < static_cast<int>(faces.size()); ++face) {
    const auto nodes = outline(face);
    sides_.resize(outline_begin_[face + 1]);
    for (const int facet : facets_of(face)) {
      const ContactFacet& f = facets[facet];
      for (int k = 0; k < 3; ++k) {
        const int node = f.nodes[k] - body.first_node;
        if (faces_at[node] > 2 && !owned[node]++) owned_nodes_.push_back(f.nodes[k]);
        const auto& beside = edges[f.edges[k]].facets;
        if (facets[beside[0]].face == facets[beside[1]].face) continue;  // inside the face
        if (beside[0] == facet) owned_edges_.push_back(f.edges[k]);
        const auto from = std::find(nodes.begin(), nodes.end(), f.nodes[(k + 1) % 3]) - nodes.begin();
        sides_[outline_begin_[face] + from] = f.edges[k];
      }
    }
    end_row(owned_nodes_begin_, owned_nodes_);
    end_row(owned_edges_begin_, owned_edges_);
  }
}

void ContactFeatures::set_movable(const ContactBody& body, bool movable_now) {
  std::fill_n(movable.begin() + body.first_node, body.surface->ring.size(), movable_now);
  const int number = body_of_[body.first_node];
  if (movable_now && !single_[number]) keeps_shape_[number] = false;
}

void ContactFeatures::link_nodes() {
  std::vector<std::vector<int>> ring(node_count()), ends(node_count()), at(node_count());
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    if (facets[edges[e].facets[0]].face == facets[edges[e].facets[1]].face) continue;  // inside it
    const auto [a, b] = edges[e].nodes;
    ring[a].push_back(b);
    ring[b].push_back(a);
    for (const int node : edges[e].nodes) ends[node].push_back(e);
  }
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    for (int n : outline(f)) at[n].push_back(faces[f].facet);
  }
  const auto flatten = [](const std::vector<std::vector<int>>& rows, std::vector<int>& begin, std::vector<int>& items) {
    begin.push_back(0);
    for (const auto& r : rows) {
      items.insert(items.end(), r.begin(), r.end());
      begin.push_back(static_cast<int>(items.size()));
    }
  };
  flatten(ring, ring_begin_, ring_);
  flatten(ends, edges_at_begin_, edges_at_);
  flatten(at, facets_at_begin_, facets_at_);
}

}  // namespace talus
