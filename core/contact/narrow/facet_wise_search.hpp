#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/narrow/polygon_overlap.hpp"
#include "contact/narrow/step_geometry.hpp"

namespace talus {

/// The paper's method, to compare with: a common plane for each pair of facets, and the contact points that this plane
/// alone gives. Nothing is known of the facets around.
class FacetWiseSearch {
 public:
  void find(const StepGeometry& step, std::span<const FacePair> pairs, FoundPoints& found);

 private:
  struct FacetPair {
    int a, b;
  };
  struct Touch {
    std::uint64_t key;
    int order;
    FacetPair facets;
    Vec3 normal;
    double gap, area;
    int node;                  // −1: two edges cross
    std::array<int, 2> edges;  // of a crossing
    std::array<double, 3> at;  // barycentric coordinates on the facet, or fractions along both edges
  };
  void touch(const StepGeometry& step, const FacetPair& pair);
  void vertices_on(const StepGeometry& step, const FacetPair& pair, bool node_is_first, const Vec3& n);
  void crossings(const StepGeometry& step, const FacetPair& pair, const Vec3& n);
  void keep(const StepGeometry& step, Touch touch);
  double common_area(const StepGeometry& step, const FacetPair& pair, const Vec3& n);

  std::vector<Touch> touches_;
  OverlapPolygon overlap_;
};

}  // namespace talus
