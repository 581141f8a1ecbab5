#include "geometry/mesher/cells/facet_outlines.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "geometry/mesher/cells/face_border.hpp"

namespace talus {
namespace {

template <class Item>
void sort_once(std::vector<Item>& items) {
  std::ranges::sort(items);
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

bool has(const std::vector<int>& sorted, int item) { return std::ranges::binary_search(sorted, item); }

/// The cells' faces that no other of them has, those of one mark after each other.
std::vector<const CellFace*> skin_of(const CellSolid& solid, std::span<const int> cells) {
  std::vector<int> own(cells.begin(), cells.end());
  std::ranges::sort(own);
  std::vector<const CellFace*> skin;
  for (int index : cells) {
    const auto c = static_cast<std::size_t>(index);
    const Cell& cell = solid.complex.cells()[c];
    for (std::size_t f = 0; f < cell.size(); ++f)
      if (cell[f].mark != between_cells && !has(own, solid.across[c][f])) skin.push_back(&cell[f]);
  }
  std::ranges::stable_sort(skin, {}, &CellFace::mark);
  return skin;
}

std::vector<FacetOutline> outlines_of(const CellSolid& solid, std::span<const int> cells) {
  const std::vector<const CellFace*> skin = skin_of(solid, cells);
  std::vector<FacetOutline> outlines;
  for (auto face = skin.begin(); face != skin.end();) {
    const int mark = (*face)->mark;
    std::array<FacetOutline, 2> sides;  // a joint may bound a block from both sides
    for (; face != skin.end() && (*face)->mark == mark; ++face) {
      const Vec3 area = area_of(**face, solid.complex.vertices());
      FacetOutline& outline = sides[sides[0].normal.dot(area) < 0 ? 1 : 0];
      outline.mark = mark;
      outline.normal += area;
      add_edges(**face, outline.edges);
    }
    for (FacetOutline& outline : sides) {
      outline.edges = border_of(std::move(outline.edges));
      if (!outline.edges.empty()) outlines.push_back(std::move(outline));
    }
  }
  return outlines;
}

/// Vertices in the middle of a straight edge of the block, ascending.
std::vector<int> needless_vertices(const std::vector<FacetOutline>& outlines, const CellComplex& complex) {
  std::vector<DirectedEdge> neighbours;  // from each vertex
  for (const FacetOutline& outline : outlines)
    for (const auto& [from, to] : outline.edges) {
      neighbours.emplace_back(from, to);
      neighbours.emplace_back(to, from);
    }
  sort_once(neighbours);
  std::vector<int> needless;
  constexpr double straight = 1e-9;
  for (auto first = neighbours.begin(), end = first; first != neighbours.end(); first = end) {
    const int vertex = first->first;
    while (end != neighbours.end() && end->first == vertex) ++end;
    if (end - first != 2) continue;
    const Vec3 a = complex.vertex(first->second) - complex.vertex(vertex);
    const Vec3 b = complex.vertex((first + 1)->second) - complex.vertex(vertex);
    if (a.dot(b) < 0 && a.cross(b).norm() < straight * a.norm() * b.norm()) needless.push_back(vertex);
  }
  return needless;
}

/// The edges with needless vertices left out, from each of which one edge goes.
std::vector<DirectedEdge> lengthened(const std::vector<DirectedEdge>& edges, const std::vector<int>& needless) {
  const auto next = [&](int vertex) {
    return std::ranges::lower_bound(edges, vertex, {}, &DirectedEdge::first)->second;
  };
  std::vector<DirectedEdge> longer;
  for (const auto& [from, to] : edges) {
    if (has(needless, from)) continue;
    int end = to;
    while (has(needless, end)) end = next(end);
    if (end != from) longer.emplace_back(from, end);
  }
  sort_once(longer);
  return longer;
}

}  // namespace

std::vector<FacetOutline> facet_outlines(const CellSolid& solid, std::span<const int> cells) {
  std::vector<FacetOutline> outlines = outlines_of(solid, cells);
  const std::vector<int> needless = needless_vertices(outlines, solid.complex);
  for (FacetOutline& outline : outlines) outline.edges = lengthened(outline.edges, needless);
  std::erase_if(outlines, [](const FacetOutline& outline) { return outline.edges.size() < 3; });
  return outlines;
}

int corner_count(const CellSolid& solid, std::span<const int> cells) {
  std::vector<int> corners;
  for (const FacetOutline& outline : facet_outlines(solid, cells))
    for (const auto& [from, to] : outline.edges) corners.push_back(from);
  sort_once(corners);
  return static_cast<int>(corners.size());
}

}  // namespace talus
