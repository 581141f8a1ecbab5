#pragma once

#include <span>

#include "contact/narrow/step_geometry.hpp"

namespace talus {

class VertexFaceSearch;

/// Convex edges that cross. Face–face points and vertices on faces must be there already.
class EdgeEdgeSearch {
 public:
  void find(const StepGeometry& step, std::span<const FacetPair> pairs, const VertexFaceSearch& vertices,
            FoundPoints& found);

 private:
  void cross(const StepGeometry& step, int edge_a, int edge_b, const VertexFaceSearch& vertices, FoundPoints& found);
  bool found_before(const FoundPoint& p, double from_end, double near, const StepGeometry& step,
                    const FoundPoints& found) const;
};

}  // namespace talus
