#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "render/paint/theme.hpp"
#include "render/scene/block_colours.hpp"
#include "render/scene/block_surface.hpp"

namespace talus {
namespace {

using Box = Eigen::AlignedBox3d;

struct Facet {
  Vec3 a, b, c;
  Box box;
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

/// A block's surface.
struct Shell {
  std::vector<Facet> facets;
  Box box;
};

Box widened(const Box& box, double by) { return {box.min() - Vec3::Constant(by), box.max() + Vec3::Constant(by)}; }

std::vector<Shell> shells_of(const BlockSystem& system, const Vec3& origin, double tolerance) {
  std::vector<Shell> shells;
  for (const Block& block : system.blocks) {
    Shell& shell = shells.emplace_back();
    for (const SurfaceTriangle& t : block.surface) {
      const auto at = [&](int i) -> Vec3 { return block.mesh.nodes[t.nodes[i]] - origin; };
      Facet facet{at(0), at(1), at(2), {}};
      for (const Vec3& corner : {facet.a, facet.b, facet.c}) facet.box.extend(corner);
      facet.box = widened(facet.box, tolerance);
      shell.box.extend(facet.box);
      shell.facets.push_back(facet);
    }
  }
  return shells;
}

std::vector<const Facet*> facets_in(const Shell& shell, const Box& box) {
  std::vector<const Facet*> found;
  for (const Facet& facet : shell.facets)
    if (facet.box.intersects(box)) found.push_back(&facet);
  return found;
}

/// Whether a point that is strictly inside a facet of one lies on the other: blocks that meet along an edge alone do
/// not touch.
bool lie_on(const std::vector<const Facet*>& one, const std::vector<const Facet*>& other, double tolerance) {
  for (const Facet* facet : one) {
    const Vec3 centre = (facet->a + facet->b + facet->c) / 3;
    for (const Vec3& point : {centre, Vec3(0.1 * centre + 0.9 * facet->a), Vec3(0.1 * centre + 0.9 * facet->b),
                              Vec3(0.1 * centre + 0.9 * facet->c)})
      for (const Facet* under : other)
        if (under->box.contains(point) && holds(*under, point, tolerance)) return true;
  }
  return false;
}

bool touch(const Shell& one, const Shell& other, double tolerance) {
  const Box common = one.box.intersection(other.box);
  const auto here = facets_in(one, common), there = facets_in(other, common);
  return lie_on(here, there, tolerance) || lie_on(there, here, tolerance);
}

}  // namespace

std::vector<std::array<int, 2>> touching_blocks(const BlockSystem& system) {
  const Box box = bounds(system);
  if (box.isEmpty()) return {};
  const double tolerance = 1e-5 * box.diagonal().norm();
  const std::vector<Shell> shells = shells_of(system, box.min(), tolerance);
  // Boxes that overlap are found by a sweep along x.
  std::vector<int> order(shells.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return shells[a].box.min().x() < shells[b].box.min().x(); });
  std::set<std::array<int, 2>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const int a = order[i], b = order[k];
      if (shells[b].box.min().x() > shells[a].box.max().x()) break;
      if (shells[a].box.intersects(shells[b].box) && touch(shells[a], shells[b], tolerance))
        pairs.insert({std::min(a, b), std::max(a, b)});
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

std::vector<Rgb> colours_of_blocks(const BlockSystem& system) {
  const Rgb rock = colours(Theme::light).rock;
  std::vector<std::array<int, 2>> touching;
  for (const auto& pair : touching_blocks(system)) {
    const auto movable = [&](int b) { return system.blocks[b].body != BodyKind::fixed; };
    if (movable(pair[0]) && movable(pair[1])) touching.push_back(pair);
  }
  const auto& palette = block_palette();
  const std::vector<int> index =
      colour_indices(static_cast<int>(system.blocks.size()), touching, static_cast<int>(palette.size()));
  std::vector<Rgb> result;
  for (std::size_t b = 0; b < index.size(); ++b)
    result.push_back(system.blocks[b].body == BodyKind::fixed ? rock : mix(palette[index[b]], rock, 0.25));
  return result;
}

std::vector<std::array<double, 3>> fractions_of_colours(const BlockSystem& system) {
  std::vector<std::array<double, 3>> fractions;
  for (const Rgb& colour : colours_of_blocks(system))
    fractions.push_back({colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0});
  return fractions;
}

}  // namespace talus
