#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "contact/contact_settings.hpp"
#include "contact/narrow/edge_edge_search.hpp"
#include "contact/narrow/face_face_search.hpp"
#include "contact/narrow/facet_wise_search.hpp"
#include "contact/narrow/false_vertices.hpp"
#include "contact/narrow/separating_axis.hpp"
#include "contact/narrow/vertex_face_search.hpp"
#include "contact/narrow/vertex_vertex_search.hpp"

namespace talus {

/// All searches for contact points, on all cores: the pairs of facets are divided into parts, of whole pairs of bodies,
/// and each part is searched by one thread, with lists of its own. What has to be known of all bodies is joined between
/// two searches. Where one part ends hangs on the pairs alone, never on the number of threads.
class PointSearch {
 public:
  explicit PointSearch(const ContactSettings& settings) : settings_(settings) {}

  /// Facets of two bodies that are farther apart than this, or deeper behind each other, make no point. [m]
  double distance(const StepGeometry& step, int body_a, int body_b) const;

  /// The points of pairs of facets, which are sorted by bodies. Those found are sorted by key.
  void find(const StepGeometry& step, std::span<const FacePair> pairs, FoundPoints& found);
  /// The same without vertex–vertex contact, of a step that is not to be accepted: all points that are deeper than
  /// `depth` of their mesh size, and such that are not. Two convex bodies that are less deep in each other are looked
  /// at only where one of them has such a point with a third: that may hang on what else holds a vertex.
  void find_ahead(const StepGeometry& step, std::span<const FacePair> pairs, double depth, FoundPoints& found);

  /// The step was accepted whose features find() saw last.
  void accept() { std::swap(former_, seen_); }

  /// What it remembers from step to step.
  void archive(auto& state) { state(former_); }

 private:
  struct Part {
    explicit Part(const ContactTolerances& tolerances) : found(tolerances.least_stencil_weight) {}
    std::span<const FacePair> pairs;
    NearFeatures near;
    SeparatingAxis axis;
    FacetWiseSearch facet_wise;
    FaceFaceSearch face_face;
    VertexFaceSearch vertex_face;
    EdgeEdgeSearch edge_edge;
    VertexVertexSearch vertex_vertex;
    FoundPoints found;
    std::vector<int> deep_bodies;
  };
  struct Place {
    std::uint64_t key;
    int part, point;
    int stencil_begin;  // once joined
  };
  void divide(const ContactFeatures& features, std::span<const FacePair> pairs);
  template <class Work>
  void each_part(const Work& work);
  void find_near(const StepGeometry& step, Part& part) const;
  std::span<const FacePair> of_deep_bodies(const StepGeometry& step, std::span<const FacePair> pairs, double depth);
  void search_features(const StepGeometry& step);
  void search_corners(const StepGeometry& step);
  void join(FoundPoints& found);

  ContactSettings settings_;
  std::deque<Part> parts_;  // those that were needed so far: lists keep their room
  int part_count_ = 0;
  std::vector<char> is_deep_;      // a body
  std::vector<FacePair> of_deep_;  // face pairs of such bodies
  FalseVertices false_vertices_;
  Pressures pressures_;
  Sights seen_, former_;
  std::vector<Place> places_;  // sorted by key
};

}  // namespace talus
