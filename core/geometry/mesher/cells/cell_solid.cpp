#include "geometry/mesher/cells/cell_solid.hpp"

#include <algorithm>

#include "geometry/mesher/cells/face_key.hpp"

namespace talus {

std::vector<std::vector<int>> cells_across(const CellComplex& complex) {
  struct Side {
    FaceKey face;
    std::size_t cell, number;
  };
  std::vector<Side> sides;
  std::vector<std::vector<int>> across;
  for (std::size_t c = 0; c < complex.cells().size(); ++c) {
    const Cell& cell = complex.cells()[c];
    across.emplace_back(cell.size(), -1);
    for (std::size_t f = 0; f < cell.size(); ++f) sides.push_back({key_of(cell[f]), c, f});
  }
  std::ranges::stable_sort(sides, {}, &Side::face);
  for (std::size_t s = 0; s + 1 < sides.size(); ++s) {
    const Side &one = sides[s], &other = sides[s + 1];
    if (one.face != other.face) continue;
    across[one.cell][one.number] = static_cast<int>(other.cell);
    across[other.cell][other.number] = static_cast<int>(one.cell);
    ++s;
  }
  return across;
}

}  // namespace talus
