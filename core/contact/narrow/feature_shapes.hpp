#pragma once

#include <array>
#include <span>
#include <vector>

#include "contact/broad/box.hpp"
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

  /// The nodes are at x [m], which must last as long as something is asked; the odometers have been told of the motion
  /// since the last look.
  void look(std::span<const Vec3> x);

  /// Unit, outwards.
  const Vec3& normal(int face) { return has_normal_[face].is_done() ? normals_[face] : measure_normal(face); }
  /// From a node to its core, for an edge tolerance of 1: all facets around, moved inwards by 1, meet there as nearly
  /// as they can.
  const Vec3& towards_core(int node) { return has_core_[node].is_done() ? towards_core_[node] : measure_core(node); }

  struct Edge {
    Box box;  ///< about it
    bool is_convex;
    bool is_clearly_convex;    ///< by more than an angle as good as flat
    Vec3 along;                ///< unit, from its first node to the second
    std::array<Vec3, 2> into;  ///< unit vectors in each facet, square to the edge, away from it
  };
  const Edge& edge(int number) { return has_edge_[number].is_done() ? edges_[number] : measure_edge(number); }

 private:
  // Not inlined, so that asking for what was measured is.
  [[gnu::noinline]] const Vec3& measure_normal(int face);
  [[gnu::noinline]] const Vec3& measure_core(int node);
  [[gnu::noinline]] const Edge& measure_edge(int number);
  Vec3 normal_of(int face) const;
  Vec3 core_of(int node);
  Edge edge_of(int number);

  const ContactFeatures& features_;
  const Odometers& odometers_;
  const ContactTolerances& tolerances_;
  std::span<const Vec3> x_;
  std::vector<Vec3> normals_, towards_core_;
  std::vector<Edge> edges_;
  std::vector<int> node_begin_, edge_begin_;  // of body b: node_begin_[b] … node_begin_[b + 1]
  std::vector<MeasuredOnce> has_normal_, has_core_, has_edge_;
};

}  // namespace talus
