#include "model/rules/block_rules.hpp"

#include "model/require.hpp"

namespace talus {

void check(const BlockOverride& block, const Place& place) {
  require_finite(block.at, place / "at");
  if (block.mesh_size) require_positive(*block.mesh_size, place / "mesh_size", "mesh size", "m");
}

void check(const Merge& merge, const Place& place) {
  require_finite(merge.at, place / "at");
  require_finite(merge.with, place / "with");
}

void check(const Splinters& splinters, const Place& place) {
  if (splinters.thickness) require_positive(*splinters.thickness, place / "thickness", "thickness", "m");
  require(splinters.chip_volume >= 0 && splinters.chip_volume < 1, place / "chip_volume",
          "the volume of a chip is a share of that of other blocks", "give a number from 0 to less than 1");
}

void check(const MeshSettings& mesh, const Place& place) {
  if (mesh.size) require_positive(*mesh.size, place / "size", "mesh size", "m");
  for (std::size_t i = 0; i < mesh.refinements.size(); ++i) {
    const Place refinement = place / "refinements" / i;
    require_finite(mesh.refinements[i].at, refinement / "at");
    const auto& face = mesh.refinements[i].face;
    require(face.empty() || face.size() >= 3, refinement / "face", "a face has at least three corners",
            "give three corners or more, or take the face away");
    for (std::size_t k = 0; k < face.size(); ++k) require_finite(face[k], refinement / "face" / k);
    require_positive(mesh.refinements[i].radius, refinement / "radius", "radius", "m");
    require_positive(mesh.refinements[i].size, refinement / "size", "mesh size", "m");
  }
  require_positive(mesh.most_tetrahedra, place / "most_tetrahedra", "the largest number of tetrahedra", "tetrahedra");
}

}  // namespace talus
