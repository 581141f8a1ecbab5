#pragma once

#include <array>
#include <span>
#include <vector>

#include "contact/narrow/step_geometry.hpp"

namespace talus {

/// The features of two bodies each that are near enough to touch, out of pairs of faces that are sorted by bodies: what
/// all searches have in common.
class NearFeatures {
 public:
  struct VertexAtFace {
    int node, face;
    bool node_is_first;
  };
  struct VertexAtEdge {  ///< a corner and a sharp edge
    int node, edge;
    bool node_is_first;
  };
  struct EdgeAtEdge {  ///< convex ones
    int a, b;
  };
  /// Of two bodies.
  struct OfBodies {
    std::array<int, 2> bodies;
    std::span<const EdgeAtEdge> edges;
    std::span<const VertexAtEdge> corners;
  };

  /// `distance` of two bodies: beyond it features do not touch. [m]
  template <class Distance>
  void find(const StepGeometry& step, std::span<const FacePair> pairs, const Distance& distance) {
    clear();
    visit_body_pairs(step.features, pairs, [&](std::span<const FacePair> of_bodies) {
      const int a = step.features.faces[of_bodies[0].a].body, b = step.features.faces[of_bodies[0].b].body;
      add(step, {a, b}, of_bodies, distance(a, b));
    });
  }

  std::span<const FacePair> faces() const { return faces_; }
  std::span<const VertexAtFace> vertices() const { return vertices_; }
  /// Calls `visit` with what is near of two bodies each that have near faces.
  template <class Visit>
  void visit_bodies(const Visit& visit) const {
    std::size_t edges = 0, corners = 0;
    for (const Ends& end : ends_) {
      visit(OfBodies{end.bodies, std::span(edges_).subspan(edges, end.edges - edges),
                     std::span(corners_).subspan(corners, end.corners - corners)});
      edges = end.edges, corners = end.corners;
    }
  }

 private:
  struct Ends {
    std::array<int, 2> bodies;
    std::size_t edges, corners;
  };
  void clear();
  void add(const StepGeometry& step, const std::array<int, 2>& bodies, std::span<const FacePair> pairs,
           double distance);
  void add_features(const StepGeometry& step, const FacePair& pair, double distance);

  std::vector<FacePair> faces_;
  std::vector<VertexAtFace> vertices_;
  std::vector<VertexAtEdge> corners_;
  std::vector<EdgeAtEdge> edges_;
  std::vector<Ends> ends_;
  std::vector<int> of_b_;  // edges of one face
};

}  // namespace talus
