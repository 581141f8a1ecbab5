#include "mesh/quality.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.hpp"

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

DihedralRange tetrahedron_dihedrals(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto face = [](const Vec3& p, const Vec3& q, const Vec3& r) -> Vec3 { return (q - p).cross(r - p); };
  const std::array<Vec3, 4> outward{face(b, c, d), face(a, d, c), face(a, b, d), face(a, c, b)};
  DihedralRange range{180, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i + 1; k < 4; ++k) {
      const double between_normals = std::atan2(outward[i].cross(outward[k]).norm(), outward[i].dot(outward[k]));
      const double angle = 180 - degrees(between_normals);
      range.smallest = std::min(range.smallest, angle);
      range.largest = std::max(range.largest, angle);
    }
  }
  return range;
}

MeshQuality mesh_quality(const TetMesh& mesh, const QualityVisit& each) {
  if (mesh.tetrahedra.empty()) return {};
  MeshQuality quality;
  quality.mean = 0;
  for (std::size_t number = 0; number < mesh.tetrahedra.size(); ++number) {
    const auto& t = mesh.tetrahedra[number];
    const auto node = [&](std::size_t i) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(t[i])]; };
    const double value = tetrahedron_quality(node(0), node(1), node(2), node(3));
    quality.worst = std::min(quality.worst, value);
    quality.mean += value;
    const DihedralRange dihedrals = tetrahedron_dihedrals(node(0), node(1), node(2), node(3));
    quality.smallest_dihedral = std::min(quality.smallest_dihedral, dihedrals.smallest);
    quality.largest_dihedral = std::max(quality.largest_dihedral, dihedrals.largest);
    if (each) each(number, value, dihedrals);
  }
  quality.mean /= static_cast<double>(mesh.tetrahedra.size());
  return quality;
}

}  // namespace talus
