#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "render/scene/block_surface.hpp"

namespace talus {
namespace {

struct Facet {
  Vec3 a, b, c;
  int block;
};

bool holds(const Facet& facet, const Vec3& point, double tolerance) {
  const Vec3 normal = (facet.b - facet.a).cross(facet.c - facet.a);
  const double area = normal.norm();
  if (area == 0 || std::abs(normal.dot(point - facet.a)) > tolerance * area) return false;
  const auto inside = [&](const Vec3& from, const Vec3& to) {
    return (to - from).cross(point - from).dot(normal) >= 0;
  };
  return inside(facet.a, facet.b) && inside(facet.b, facet.c) && inside(facet.c, facet.a);
}

/// Facets by the cells of a coarse grid that their boxes meet.
class FacetGrid {
 public:
  FacetGrid(const std::vector<Facet>& facets, double cell) : facets_(facets), cell_(cell) {
    for (std::size_t i = 0; i < facets.size(); ++i) {
      const Facet& f = facets[i];
      const Eigen::Vector3i low = cell_of(f.a.cwiseMin(f.b).cwiseMin(f.c).array() - cell_ * 1e-3);
      const Eigen::Vector3i high = cell_of(f.a.cwiseMax(f.b).cwiseMax(f.c).array() + cell_ * 1e-3);
      for (int x = low.x(); x <= high.x(); ++x)
        for (int y = low.y(); y <= high.y(); ++y)
          for (int z = low.z(); z <= high.z(); ++z) cells_[{x, y, z}].push_back(i);
    }
  }

  template <class Visit>
  void visit_near(const Vec3& point, Visit visit) const {
    const Eigen::Vector3i cell = cell_of(point);
    const auto found = cells_.find({cell.x(), cell.y(), cell.z()});
    if (found == cells_.end()) return;
    for (const std::size_t i : found->second) visit(facets_[i]);
  }

 private:
  Eigen::Vector3i cell_of(const Vec3& point) const { return (point / cell_).array().floor().cast<int>(); }

  const std::vector<Facet>& facets_;
  double cell_;
  std::map<std::array<int, 3>, std::vector<std::size_t>> cells_;
};

std::vector<Facet> all_facets(const BlockSystem& system, Vec3 origin) {
  std::vector<Facet> facets;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const auto& nodes = system.blocks[b].mesh.nodes;
    for (const SurfaceTriangle& t : system.blocks[b].surface)
      facets.push_back(
          {nodes[t.nodes[0]] - origin, nodes[t.nodes[1]] - origin, nodes[t.nodes[2]] - origin, static_cast<int>(b)});
  }
  return facets;
}

}  // namespace

std::vector<std::array<int, 2>> touching_blocks(const BlockSystem& system) {
  const Eigen::AlignedBox3d box = bounds(system);
  if (box.isEmpty()) return {};
  const double size = box.diagonal().norm();
  const double tolerance = 1e-5 * size;
  const std::vector<Facet> facets = all_facets(system, box.min());
  const FacetGrid grid(facets, size / 40);
  std::set<std::array<int, 2>> pairs;
  for (const Facet& facet : facets) {
    const Vec3 centre = (facet.a + facet.b + facet.c) / 3;
    // Points strictly inside the facet: blocks that meet along an edge alone do not count.
    for (const Vec3& point : {centre, Vec3(0.1 * centre + 0.9 * facet.a), Vec3(0.1 * centre + 0.9 * facet.b),
                              Vec3(0.1 * centre + 0.9 * facet.c)})
      grid.visit_near(point, [&](const Facet& other) {
        if (other.block != facet.block && holds(other, point, tolerance))
          pairs.insert({std::min(facet.block, other.block), std::max(facet.block, other.block)});
      });
  }
  return {pairs.begin(), pairs.end()};
}

std::vector<int> colour_indices(int block_count, const std::vector<std::array<int, 2>>& touching, int colour_count) {
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(block_count));
  for (const auto& [a, b] : touching) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<int> order(neighbours.size());
  for (int i = 0; i < block_count; ++i) order[i] = i;
  // Those with most neighbours first: they have the least choice (Welsh and Powell).
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return neighbours[a].size() > neighbours[b].size(); });
  std::vector<int> colour(neighbours.size(), -1);
  std::vector<int> used(static_cast<std::size_t>(colour_count), 0);
  for (const int block : order) {
    std::vector<int> clashes(static_cast<std::size_t>(colour_count), 0);
    for (const int other : neighbours[block])
      if (colour[other] >= 0) ++clashes[colour[other]];
    int best = 0;
    for (int c = 1; c < colour_count; ++c)
      if (std::pair(clashes[c], used[c]) < std::pair(clashes[best], used[best])) best = c;
    colour[block] = best;
    ++used[best];
  }
  return colour;
}

}  // namespace talus
