#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/narrow/step_geometry.hpp"

namespace talus {

/// Face–face contact: facets with opposite normals touch at the corners of their overlap. Corners are merged where
/// only the mesh divides two overlaps.
class FaceFaceSearch {
 public:
  void find(const StepGeometry& step, std::span<const FacetPair> pairs, FoundPoints& found);

 private:
  struct Corner {
    std::uint64_t key;
    FacetPair facets;
    double weight;             // m²
    std::array<double, 6> at;  // barycentric coordinates on both facets
    Vec3 normal;
    int along = -1;  // as of a found point
  };
  void overlap(const StepGeometry& step, const FacetPair& pair, FoundPoints& found);
  void place_corners(const StepGeometry& step, std::size_t first);
  void name(const StepGeometry& step, Corner& corner, FoundPoints& found);
  void merge(const StepGeometry& step, FoundPoints& found);
  std::vector<Corner> corners_;
  std::array<std::vector<Vec3>, 2> places_;            // m, of the corners of one overlap, on both bodies
  std::vector<std::pair<std::uint64_t, int>> by_key_;  // keys and numbers of corners_, sorted
};

}  // namespace talus
