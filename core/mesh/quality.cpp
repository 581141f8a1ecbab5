#include "mesh/quality.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace talus {

namespace {

double area(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).norm() / 2; }

}  // namespace

double tetrahedron_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double volume = std::abs((b - a).cross(c - a).dot(d - a)) / 6;
  const double surface = area(a, b, c) + area(a, b, d) + area(a, c, d) + area(b, c, d);
  // 24 V R is the root of this product (Crelle), with p, q, r the products of opposite edges.
  const double p = (b - a).norm() * (d - c).norm();
  const double q = (c - a).norm() * (d - b).norm();
  const double r = (d - a).norm() * (c - b).norm();
  const double product = (p + q + r) * (p + q - r) * (p - q + r) * (q + r - p);
  if (!(product > 0) || !(surface > 0)) return 0;
  const double inscribed = 3 * volume / surface;
  const double circumscribed = std::sqrt(product) / (24 * volume);
  return 3 * inscribed / circumscribed;
}

MeshQuality mesh_quality(const TetMesh& mesh) {
  if (mesh.tetrahedra.empty()) return {};
  MeshQuality quality{1, 0};
  for (const auto& t : mesh.tetrahedra) {
    const auto node = [&](std::size_t i) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(t[i])]; };
    const double value = tetrahedron_quality(node(0), node(1), node(2), node(3));
    quality.worst = std::min(quality.worst, value);
    quality.mean += value;
  }
  quality.mean /= static_cast<double>(mesh.tetrahedra.size());
  return quality;
}

}  // namespace talus
