#pragma once

#include <span>

#include "contact/narrow/near_features.hpp"
#include "contact/narrow/separating_axis.hpp"
#include "contact/points_by_bodies.hpp"

namespace talus {

class VertexFaceSearch;

/// Convex edges that cross. Face–face points and vertices on faces must be there already.
class EdgeEdgeSearch {
 public:
  void find(const StepGeometry& step, const NearFeatures& near, const VertexFaceSearch& vertices, SeparatingAxis& axis,
            FoundPoints& found);

 private:
  void cross(const StepGeometry& step, const NearFeatures::EdgeAtEdge& near, double depth,
             const VertexFaceSearch& vertices, SeparatingAxis& axis, FoundPoints& found);
  bool found_before(const FoundPoint& p, double near, const StepGeometry& step, const FoundPoints& found) const;

  PointsByBodies vertices_;  // of the vertices on faces
  std::size_t first_ = 0;    // point of the two bodies that are looked at
};

}  // namespace talus
