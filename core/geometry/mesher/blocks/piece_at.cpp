#include "geometry/mesher/blocks/piece_at.hpp"

#include <gmsh.h>

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "geometry/mesher/facet.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

/// Inside or on the border. gmsh's own test of a point answers for surfaces only; a point's intersection with the
/// volume is exact for curved faces too.
bool holds(int volume, const Vec3& point) {
  if (!bounds_of_volume(volume).contains(point)) return false;
  const int tag = occ::addPoint(point.x(), point.y(), point.z());
  gmsh::vectorpair common;
  std::vector<gmsh::vectorpair> ancestry;
  occ::intersect({{0, tag}}, {{3, volume}}, common, ancestry, -1, true, false);
  if (common.empty()) return false;
  occ::remove(common);
  return true;
}

bool holds(const CutBlock& piece, const CutModel& cut, const Vec3& point) {
  if (piece.cells.empty())
    return std::any_of(piece.volume_tags.begin(), piece.volume_tags.end(),
                       [&](int volume) { return holds(volume, point); });
  const CellComplex& complex = cut.cells.at(piece.solid).complex;
  return piece.bounds.contains(point) && std::any_of(piece.cells.begin(), piece.cells.end(), [&](int cell) {
           return holds(complex.cells()[static_cast<std::size_t>(cell)], complex.vertices(), point);
         });
}

}  // namespace

std::size_t piece_at(const PiecePoint& point, const CutModel& cut, std::span<const std::string> names) {
  std::vector<std::size_t> found;
  for (std::size_t b = 0; b < cut.blocks.size(); ++b)
    if (holds(cut.blocks[b], cut, point.where)) found.push_back(b);
  const std::string remedy = "move it inside the block that is meant", its = "its point \"" + std::string(point.key);
  if (found.empty()) throw InputError(point.title, its + "\" lies in no block", remedy);
  if (found.size() > 1) {
    throw InputError(point.title, its + "\" lies on the border of " + names[found[0]] + " and " + names[found[1]],
                     remedy);
  }
  return found.front();
}

}  // namespace talus
