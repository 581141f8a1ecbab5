#include "mesh/digest.hpp"

#include <bit>

#include "base/hash.hpp"

namespace talus {

std::uint64_t digest(const BlockSystem& system) {
  std::uint64_t hash = hash_of_nothing;
  const auto add = [&](std::uint64_t number) { hash = hash_with(hash, number); };
  const auto add_all = [&](const auto& numbers) {
    for (const auto number : numbers) add(static_cast<std::uint64_t>(number));
  };
  for (const Block& block : system.blocks) {
    add(static_cast<std::uint64_t>(block.body));
    add(static_cast<std::uint64_t>(block.material));
    for (const Vec3& node : block.mesh.nodes)
      for (const double coordinate : node) add(std::bit_cast<std::uint64_t>(coordinate));
    for (const auto& tetrahedron : block.mesh.tetrahedra) add_all(tetrahedron);
    for (const SurfaceTriangle& triangle : block.surface) {
      add_all(triangle.nodes);
      add(static_cast<std::uint64_t>(triangle.joint));
    }
  }
  return hash;
}

}  // namespace talus
