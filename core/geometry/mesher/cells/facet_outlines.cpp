#include "geometry/mesher/cells/facet_outlines.hpp"

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <unordered_set>

namespace talus {
namespace {

using Edge = std::pair<int, int>;

/// The cells' faces that no other of them has.
std::vector<const CellFace*> skin_of(const CellSolid& solid, std::span<const int> cells) {
  const std::unordered_set<int> own(cells.begin(), cells.end());
  std::vector<const CellFace*> skin;
  for (int index : cells) {
    const auto c = static_cast<std::size_t>(index);
    const Cell& cell = solid.complex.cells()[c];
    for (std::size_t f = 0; f < cell.size(); ++f)
      if (cell[f].mark != between_cells && !own.contains(solid.across[c][f])) skin.push_back(&cell[f]);
  }
  return skin;
}

void add(FacetOutline& outline, const CellFace& face) {
  for (std::size_t k = 0; k < face.corners.size(); ++k) {
    const Edge edge{face.corners[k], face.corners[(k + 1) % face.corners.size()]};
    if (outline.edges.erase({edge.second, edge.first}) == 0) outline.edges.insert(edge);
  }
}

std::vector<FacetOutline> outlines_of(const CellSolid& solid, std::span<const int> cells) {
  std::map<int, std::array<FacetOutline, 2>> by_mark;  // a joint may bound a block from both sides
  for (const CellFace* face : skin_of(solid, cells)) {
    auto& sides = by_mark[face->mark];
    const Vec3 area = area_of(*face, solid.complex.vertices());
    const bool other = sides[0].normal.dot(area) < 0;
    FacetOutline& outline = sides[other ? 1 : 0];
    outline.mark = face->mark;
    outline.normal += area;
    add(outline, *face);
  }
  std::vector<FacetOutline> outlines;
  for (auto& [mark, sides] : by_mark)
    for (FacetOutline& outline : sides)
      if (!outline.edges.empty()) outlines.push_back(std::move(outline));
  return outlines;
}

/// Vertices in the middle of a straight edge of the block.
std::set<int> needless_vertices(const std::vector<FacetOutline>& outlines, const CellComplex& complex) {
  std::map<int, std::set<int>> neighbours;
  for (const FacetOutline& outline : outlines) {
    for (const auto& [from, to] : outline.edges) {
      neighbours[from].insert(to);
      neighbours[to].insert(from);
    }
  }
  std::set<int> needless;
  constexpr double straight = 1e-9;
  for (const auto& [vertex, around] : neighbours) {
    if (around.size() != 2) continue;
    const Vec3 a = complex.vertex(*around.begin()) - complex.vertex(vertex);
    const Vec3 b = complex.vertex(*around.rbegin()) - complex.vertex(vertex);
    if (a.dot(b) < 0 && a.cross(b).norm() < straight * a.norm() * b.norm()) needless.insert(vertex);
  }
  return needless;
}

/// The edges with needless vertices left out.
std::set<Edge> lengthened(const std::set<Edge>& edges, const std::set<int>& needless) {
  std::map<int, int> next;  // of needless vertices alone: such a one has one edge that comes and one that goes
  for (const auto& [from, to] : edges)
    if (needless.contains(from)) next[from] = to;
  std::set<Edge> longer;
  for (const auto& [from, to] : edges) {
    if (needless.contains(from)) continue;
    int end = to;
    while (needless.contains(end)) end = next.at(end);
    if (end != from) longer.emplace(from, end);
  }
  return longer;
}

}  // namespace

std::vector<FacetOutline> facet_outlines(const CellSolid& solid, std::span<const int> cells) {
  std::vector<FacetOutline> outlines = outlines_of(solid, cells);
  const std::set<int> needless = needless_vertices(outlines, solid.complex);
  for (FacetOutline& outline : outlines) outline.edges = lengthened(outline.edges, needless);
  std::erase_if(outlines, [](const FacetOutline& outline) { return outline.edges.size() < 3; });
  return outlines;
}

int corner_count(const CellSolid& solid, std::span<const int> cells) {
  std::unordered_set<int> corners;
  for (const FacetOutline& outline : facet_outlines(solid, cells))
    for (const auto& [from, to] : outline.edges) corners.insert(from);
  return static_cast<int>(corners.size());
}

}  // namespace talus
