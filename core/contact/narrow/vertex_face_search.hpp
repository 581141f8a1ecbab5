#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/narrow/near_features.hpp"
#include "contact/narrow/separating_axis.hpp"

namespace talus {

/// Vertices on facets, each once for every smooth face. Face–face points must be there already. Which of them are false
/// is seen when those of all bodies are there (FalseVertices).
class VertexFaceSearch {
 public:
  void find(const StepGeometry& step, const NearFeatures& near, SeparatingAxis& axis, FoundPoints& found);
  /// Whether the last search, or the face–face search before it, found the vertex on the smooth face; even if the
  /// contact was false.
  bool has(int node, int smooth_face) const;

 private:
  struct Touch {
    std::uint64_t key;
    int node, facet;
    bool node_is_first, is_beside;  // the latter as FoundPoint's
    std::array<double, 3> at;       // barycentric coordinates on the facet
    double inside;  // the smallest of them: of a smooth face's facets the one where it is largest is taken
  };
  void touch(const StepGeometry& step, const NearFeatures::VertexAtFace& near, double depth, SeparatingAxis& axis);
  static void locate(const StepGeometry& step, int facet, const Vec3& place, Touch& touch);
  void add(const StepGeometry& step, const Touch& touch, FoundPoints& found);

  std::vector<Touch> touches_;
  std::vector<std::uint64_t> taken_;
};

}  // namespace talus
