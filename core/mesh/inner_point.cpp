#include "mesh/inner_point.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

namespace talus {

Vec3 inner_point(const TetMesh& mesh) {
  if (mesh.tetrahedra.empty()) throw std::invalid_argument("a mesh without tetrahedra has no inside");
  double largest = -1;
  Vec3 centre = Vec3::Zero();
  for (const auto& t : mesh.tetrahedra) {
    const Vec3 &a = mesh.nodes[t[0]], &b = mesh.nodes[t[1]], &c = mesh.nodes[t[2]], &d = mesh.nodes[t[3]];
    // Twice the areas of the faces opposite to a, b, c and d: the weights of the corners in the ball's centre.
    const double wa = (c - b).cross(d - b).norm(), wb = (c - a).cross(d - a).norm(), wc = (b - a).cross(d - a).norm(),
                 wd = (b - a).cross(c - a).norm();
    const double sum = wa + wb + wc + wd;
    const double radius = std::abs((b - a).cross(c - a).dot(d - a)) / sum;  // 3 V / A
    if (radius <= largest) continue;
    largest = radius;
    centre = (wa * a + wb * b + wc * c + wd * d) / sum;
  }
  return centre;
}

}  // namespace talus
