#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/mesher/cells/cell_complex.hpp"

namespace talus {

/// From one vertex to the next.
using DirectedEdge = std::pair<int, int>;

/// Adds the edges of a face, in the order of its corners.
inline void add_edges(const CellFace& face, std::vector<DirectedEdge>& edges) {
  for (std::size_t k = 0; k < face.corners.size(); ++k)
    edges.emplace_back(face.corners[k], face.corners[(k + 1) % face.corners.size()]);
}

/// Of the edges of some faces, those around the area of all, ascending: two faces go along an edge between them in
/// opposite directions.
inline std::vector<DirectedEdge> border_of(std::vector<DirectedEdge> edges) {
  std::ranges::sort(edges);
  std::vector<DirectedEdge> border;
  for (const auto& [from, to] : edges)
    if (!std::ranges::binary_search(edges, DirectedEdge(to, from))) border.emplace_back(from, to);
  return border;
}

}  // namespace talus
