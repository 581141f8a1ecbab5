#pragma once

#include <cstdint>
#include <deque>
#include <span>
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
  /// The same without vertex–vertex contact, of a step that is not to be accepted.
  void find_ahead(const StepGeometry& step, std::span<const FacePair> pairs, FoundPoints& found);

  /// The step was accepted whose features find() saw last.
  void accept() { former_.swap(seen_); }

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
  void search_features(const StepGeometry& step);
  void search_corners(const StepGeometry& step);
  void join(FoundPoints& found);

  ContactSettings settings_;
  std::deque<Part> parts_;  // those that were needed so far: lists keep their room
  int part_count_ = 0;
  FalseVertices false_vertices_;
  std::vector<Pressure> pressures_;
  std::vector<Sight> seen_, former_;  // sorted by key
  std::vector<Place> places_;         // sorted by key
};

}  // namespace talus
