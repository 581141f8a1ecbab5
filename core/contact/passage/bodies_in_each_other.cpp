#include "contact/passage/bodies_in_each_other.hpp"

#include <algorithm>
#include <limits>

namespace talus {
namespace {

constexpr double at_first_per_depth = 2;

std::vector<Surface> surfaces_of(const BlockSystem& system) {
  std::vector<Surface> surfaces;
  for (const Block& block : system.blocks) surfaces.push_back(make_surface(block.mesh.nodes, block.surface));
  return surfaces;
}

}  // namespace

BodiesInEachOther::BodiesInEachOther(const BlockSystem& system, const BodySet& set)
    : BodiesInEachOther(system, set, surfaces_of(system)) {}

BodiesInEachOther::BodiesInEachOther(const BlockSystem& system, const BodySet& set, std::span<const Surface> surfaces)
    : pieces_(system, set, surfaces), near_(pieces_) {
  visit_pairs(set, [&](Bodies bodies, double) {
    if (const auto deep = depth(set, bodies, 0)) at_first_[bodies] = deep->depth;
  });
}

/// Calls `visit(bodies, size)` with all pairs whose boxes meet and of which one was built to move.
template <class Visit>
void BodiesInEachOther::visit_pairs(const BodySet& set, const Visit& visit) {
  near_.set_span(set.nodes.position, set.nodes.position, set);
  for (int a = 0; a < static_cast<int>(pieces_.bodies()); ++a)
    for (const int b : near_.near(a)) {
      const double size = pieces_.size(a, b);
      if (a < b && size < std::numeric_limits<double>::infinity()) visit(Bodies{a, b}, size);
    }
}

std::optional<DeepPair> BodiesInEachOther::look(const BodySet& set, double allowed) {
  std::optional<DeepPair> worst;
  double most = 1;  // of what a pair may
  visit_pairs(set, [&](Bodies bodies, double size) {
    double may = allowed * size;
    if (const auto before = at_first_.find(bodies); before != at_first_.end())
      may = std::max(may, at_first_per_depth * before->second);
    const auto deep = depth(set, bodies, most * may);
    if (!deep) return;
    most = deep->depth / may;
    worst = deep;
  });
  return worst;
}

std::optional<DeepPair> BodiesInEachOther::depth(const BodySet& set, Bodies bodies, double enough) {
  const auto [a, b] = bodies;
  const auto where = [&](int node) { return set.nodes.position[node]; };
  const bool whole = pieces_.count(a) == 1 && pieces_.count(b) == 1;
  std::optional<DeepPair> deepest;
  for (const auto& [i, j] : near_.near(a, b)) {
    first_.place(pieces_.piece(a, i), where);
    second_.place(pieces_.piece(b, j), where);
    if (whole)
      if (const auto last = directions_.find(bodies);
          last != directions_.end() && gap_along(last->second, first_, second_) >= -enough)
        return std::nullopt;
    const Gap gap = widest_gap(first_, second_, -enough);
    if (whole) directions_[bodies] = gap.direction;
    if (gap.width >= -enough) continue;
    enough = -gap.width;
    deepest = DeepPair{{a, b}, deepest_corner(gap.direction, first_, second_), -gap.width, pieces_.size(a, b)};
  }
  return deepest;
}

}  // namespace talus
