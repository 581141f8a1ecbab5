#pragma once

#include <map>
#include <utility>
#include <vector>

#include "geometry/mesher/cells/block_skin.hpp"
#include "geometry/mesher/cells/facet_outlines.hpp"

namespace talus {

/// The vertices of a block's skin: those of its cells, and those that are put onto edges and into faces.
class SkinVertices {
 public:
  explicit SkinVertices(const CellComplex& complex) : complex_(complex) {}

  const Vec3& operator[](int index) const;
  int add(const Vec3& vertex);
  std::vector<Vec3> take_more() { return std::move(more_); }

 private:
  const CellComplex& complex_;
  std::vector<Vec3> more_;
};

/// Divides the edges of all outlines as finely as the size says; what two outlines share is divided once.
void divide_edges(std::vector<FacetOutline>& outlines, SkinVertices& vertices, const SkinSize& size);

}  // namespace talus
