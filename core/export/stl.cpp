#include <bit>
#include <cstdint>

#include "export/export.hpp"

namespace talus {

namespace {

static_assert(std::endian::native == std::endian::little);

void append(std::string& bytes, const Vec3& vector) {
  for (const double value : vector) {
    const auto number = static_cast<float>(value);
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
}

}  // namespace

std::string stl_of(const BlockSystem& system, const Frame& frame) {
  constexpr std::size_t header = 80;
  std::string bytes = "Talus: surface of all blocks, m";
  bytes.resize(header, ' ');
  std::uint32_t count = 0;
  for (const Block& block : system.blocks) count += static_cast<std::uint32_t>(block.surface.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  std::size_t first = 0;
  for (const Block& block : system.blocks) {
    const auto at = [&](int node) -> Vec3 {
      return block.mesh.nodes[static_cast<std::size_t>(node)] +
             frame.displacement[first + static_cast<std::size_t>(node)];
    };
    for (const SurfaceTriangle& triangle : block.surface) {
      const Vec3 a = at(triangle.nodes[0]), b = at(triangle.nodes[1]), c = at(triangle.nodes[2]);
      append(bytes, (b - a).cross(c - a).normalized());
      for (const Vec3& corner : {a, b, c}) append(bytes, corner);
      bytes.append(2, '\0');
    }
    first += block.mesh.nodes.size();
  }
  return bytes;
}

}  // namespace talus
