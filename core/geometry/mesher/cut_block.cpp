#include "geometry/mesher/cut_block.hpp"

#include <algorithm>
#include <tuple>

namespace talus {

double CutBlock::area() const {
  double sum = 0;
  for (const auto& [tag, facet] : facets) sum += facet.area;
  return sum;
}

double CutBlock::thickness() const {
  const double surface = area();
  return surface > 0 ? 2 * volume / surface : 0;
}

void sort_by_place(std::vector<CutBlock>& blocks, double longest_side) {
  const double grain = 1e-6 * longest_side;
  const auto order = [&](const CutBlock& block) {
    const Vec3 square = (block.centroid / grain).array().round();
    return std::tuple(square.x(), square.y(), square.z());
  };
  std::sort(blocks.begin(), blocks.end(), [&](const CutBlock& a, const CutBlock& b) { return order(a) < order(b); });
}

double shared_area(const CutBlock& a, const CutBlock& b) {
  double area = 0;
  for (const auto& [tag, facet] : a.facets)
    if (b.facets.contains(tag)) area += facet.area;
  return area;
}

void join(CutBlock& block, const CutBlock& other) {
  block.centroid = (block.volume * block.centroid + other.volume * other.centroid) / (block.volume + other.volume);
  block.volume += other.volume;
  block.bounds.extend(other.bounds);
  block.volume_tags.insert(block.volume_tags.end(), other.volume_tags.begin(), other.volume_tags.end());
  block.cells.insert(block.cells.end(), other.cells.begin(), other.cells.end());
  for (const auto& [tag, facet] : other.facets)
    if (!block.facets.emplace(tag, facet).second) block.facets.erase(tag);
}

}  // namespace talus
