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
  struct EdgeAtEdge {
    int a, b;
  };
  /// Of two bodies.
  struct OfBodies {
    std::array<int, 2> bodies;
    double depth;  ///< m, how deep they can lie in each other
    std::span<const VertexAtFace> vertices;
    std::span<const EdgeAtEdge> crossing, parallel;
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
  /// Those of them that look at each other, to within the angle of face–face contact.
  std::span<const FacePair> facing() const { return facing_; }
  /// Calls `visit` with what is near of two bodies each that have near faces.
  template <class Visit>
  void visit_bodies(const Visit& visit) const {
    Ends begin{};
    for (const Ends& end : ends_) {
      visit(OfBodies{end.bodies, end.depth, std::span(vertices_).subspan(begin.vertices, end.vertices - begin.vertices),
                     std::span(crossing_).subspan(begin.crossing, end.crossing - begin.crossing),
                     std::span(parallel_).subspan(begin.parallel, end.parallel - begin.parallel),
                     std::span(corners_).subspan(begin.corners, end.corners - begin.corners)});
      begin = end;
    }
  }

 private:
  struct Ends {
    std::array<int, 2> bodies;
    double depth;  // m
    std::size_t vertices, crossing, parallel, corners;
  };
  void clear();
  void add(const StepGeometry& step, const std::array<int, 2>& bodies, std::span<const FacePair> pairs,
           double distance);
  void add_features(const StepGeometry& step, const FacePair& pair, double distance);

  void add_edges(const StepGeometry& step, int edge_a, int edge_b);

  std::vector<FacePair> faces_, facing_;
  std::vector<VertexAtFace> vertices_;
  std::vector<VertexAtEdge> corners_;
  std::vector<EdgeAtEdge> crossing_;  // clearly convex ones
  std::vector<EdgeAtEdge> parallel_;  // as good as; convex, sharp ones
  std::vector<Ends> ends_;
};

}  // namespace talus
