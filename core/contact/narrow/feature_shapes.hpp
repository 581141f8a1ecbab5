#pragma once

#include <array>
#include <span>
#include <vector>

#include "contact/broad/measured_once.hpp"
#include "contact/broad/odometers.hpp"
#include "contact/contact_features.hpp"
#include "model/tolerances.hpp"

namespace talus {

/// What features look like at the positions of a step: each is measured when it is asked for and its body has moved
/// since, so that nobody measures anything twice, nor what is not near another body. Several threads may ask at once:
/// the first to ask measures, who asks for the same meanwhile waits.
class FeatureShapes {
 public:
  /// All outlive this.
  FeatureShapes(const ContactFeatures& features, const Odometers& odometers, const ContactTolerances& tolerances);

  /// The nodes are at x [m], which must last as long as something is asked; the odometers have been told of the motion.
  void look(std::span<const Vec3> x) { x_ = x; }

  /// Unit, outwards.
  const Vec3& normal(int face) {
    normal_at_[face].bring_to(odometers_.moves(body_of_face_[face]), [&] { measure_normal(face); });
    return normals_[face];
  }
  /// From a node to its core, for an edge tolerance of 1: all facets around, moved inwards by 1, meet there as nearly
  /// as they can.
  const Vec3& towards_core(int node) {
    core_at_[node].bring_to(odometers_.moves(features_.body_of(node)), [&] { measure_core(node); });
    return towards_core_[node];
  }

  struct Edge {
    bool is_convex;
    bool is_clearly_convex;    ///< by more than an angle as good as flat
    Vec3 along;                ///< unit, from its first node to the second
    std::array<Vec3, 2> into;  ///< unit vectors in each facet, square to the edge, away from it
  };
  const Edge& edge(int number) {
    edge_at_[number].bring_to(odometers_.moves(body_of_edge_[number]), [&] { measure_edge(number); });
    return edges_[number];
  }

 private:
  void measure_normal(int face);
  void measure_core(int node);
  void measure_edge(int number);

  const ContactFeatures& features_;
  const Odometers& odometers_;
  const ContactTolerances& tolerances_;
  std::span<const Vec3> x_;
  std::vector<Vec3> normals_, towards_core_;
  std::vector<Edge> edges_;
  std::vector<int> body_of_face_, body_of_edge_;  // side by side: they are asked for all the time
  std::vector<MeasuredOnce> normal_at_, core_at_, edge_at_;
};

}  // namespace talus
