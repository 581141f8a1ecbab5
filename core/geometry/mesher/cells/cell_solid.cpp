#include "geometry/mesher/cells/cell_solid.hpp"

#include <unordered_map>
#include <utility>

#include "geometry/mesher/cells/face_key.hpp"

namespace talus {

std::vector<std::vector<int>> cells_across(const CellComplex& complex) {
  std::vector<std::vector<int>> across;
  std::unordered_map<FaceKey, std::pair<std::size_t, std::size_t>, FaceKeyHash> open;  // cell and face
  for (std::size_t c = 0; c < complex.cells().size(); ++c) {
    const Cell& cell = complex.cells()[c];
    across.emplace_back(cell.size(), -1);
    for (std::size_t f = 0; f < cell.size(); ++f) {
      const auto [known, fresh] = open.try_emplace(key_of(cell[f]), c, f);
      if (fresh) continue;
      const auto [other, face] = known->second;
      across[c][f] = static_cast<int>(other);
      across[other][face] = static_cast<int>(c);
      open.erase(known);
    }
  }
  return across;
}

}  // namespace talus
