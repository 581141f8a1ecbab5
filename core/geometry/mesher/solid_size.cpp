#include "geometry/mesher/solid_size.hpp"

#include <algorithm>

namespace talus {

double mesh_size_of(const MesherSolid& solid, const ImportedSolid& imported) {
  return solid.mesh_size.value_or(imported.longest_side() / 10);
}

double least_thickness(const MesherSolid& solid, const ImportedSolid& imported) {
  constexpr double near = 1e-4;
  return near * std::min(mesh_size_of(solid, imported), imported.longest_side() / 10);
}

}  // namespace talus
