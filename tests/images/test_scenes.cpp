#include "images/test_scenes.hpp"

#include <cmath>

#include "mesh/structured_mesh.hpp"

namespace talus {

Block hexahedron(const std::string& name, const std::array<Vec3, 8>& corners, int n, BodyKind body) {
  Block block;
  block.name = name;
  block.body = body;
  block.mesh = hexahedron_mesh(corners, n, n, n);
  block.surface = boundary(block.mesh);
  block.volume = volume(block.mesh);
  return block;
}

Block box(const std::string& name, const Vec3& low, const Vec3& high, int n, BodyKind body) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[static_cast<std::size_t>(i)] = {i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                                            i & 4 ? high.z() : low.z()};
  return hexahedron(name, corners, n, body);
}

BlockSystem two_boxes() {
  BlockSystem system;
  system.blocks = {box("plate", {-0.5, -0.5, -0.25}, {2.5, 1.5, 0}, 2, BodyKind::fixed),
                   box("B1", {0, 0, 0}, {1, 1, 1}, 2, BodyKind::tetrahedra),
                   box("B2", {1, 0, 0}, {2, 1, 1}, 2, BodyKind::tetrahedra)};
  return system;
}

BlockSystem jointed_slope() {
  const double rise = std::tan(30 * 3.14159265358979 / 180);
  const auto prism = [&](double x0, double x1, double y0, double y1, double bottom0, double bottom1, double top0,
                         double top1) {
    return std::array<Vec3, 8>{Vec3(x0, y0, bottom0), Vec3(x1, y0, bottom1), Vec3(x0, y1, bottom0),
                               Vec3(x1, y1, bottom1), Vec3(x0, y0, top0),    Vec3(x1, y0, top1),
                               Vec3(x0, y1, top0),    Vec3(x1, y1, top1)};
  };
  BlockSystem system;
  system.blocks.push_back(hexahedron("toe", prism(-24, 0, 0, 24, -5, -5, 0, 0), 1, BodyKind::fixed));
  system.blocks.push_back(hexahedron("slope", prism(0, 40, 0, 24, -5, -5, 0, 40 * rise), 1, BodyKind::fixed));
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i) {
      const double x0 = 5 + 7.0 * i, x1 = x0 + 7, y0 = 3 + 6.0 * j, y1 = y0 + 6, thick = 5;
      const std::string name = "B" + std::to_string(4 * j + i + 1);
      system.blocks.push_back(
          hexahedron(name, prism(x0, x1, y0, y1, x0 * rise, x1 * rise, x0 * rise + thick, x1 * rise + thick), 3,
                     BodyKind::tetrahedra));
    }
  return system;
}

std::shared_ptr<Frame> slid(const BlockSystem& slope, double distance, double time) {
  auto frame = std::make_shared<Frame>();
  frame->time = time;
  const Vec3 down = Vec3(-std::sqrt(3.0) / 2, 0, -0.5);
  for (const Block& block : slope.blocks) {
    const bool moves = block.body != BodyKind::fixed;
    const Vec3 corner = block.mesh.nodes.front();
    const double share = moves ? std::pow((33 - corner.x()) / 28, 1.5) * (1 - 0.03 * (corner.y() - 9)) : 0;
    for (const Vec3& node : block.mesh.nodes) {
      frame->displacement.push_back(share * distance * down);
      frame->velocity.push_back(share * down * (1 + 0.02 * node.z()));
    }
    for (const auto& tet : block.mesh.tetrahedra) {
      Voigt stress = Voigt::Zero();
      const Vec3& x = block.mesh.nodes[static_cast<std::size_t>(tet[0])];
      if (moves) stress[2] = -26e3 * (x.x() * 0.577 + 5 - x.z() + 1);
      frame->stress.push_back(stress);
    }
    if (moves)
      frame->contacts.push_back({.position = corner + share * distance * down,
                                 .normal = Vec3(-0.5, 0, 0.866),
                                 .blocks = {1, 2},
                                 .joint = 0,
                                 .state = share > 0.5 ? ContactState::slip : ContactState::stick,
                                 .normal_force = 1e6,
                                 .shear_force = Vec3::Zero(),
                                 .area = 1});
  }
  return frame;
}

}  // namespace talus
