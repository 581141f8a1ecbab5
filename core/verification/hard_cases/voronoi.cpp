#include "verification/hard_cases/voronoi.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "verification/hard_cases/shapes.hpp"

namespace talus {

namespace {

using Polygon = std::vector<Vec3>;  // counter-clockwise seen from outside
using Faces = std::vector<Polygon>;

Faces box_faces(const Vec3& a, const Vec3& b) {
  const auto at = [&](int k) { return Vec3(k & 1 ? b.x() : a.x(), k & 2 ? b.y() : a.y(), k & 4 ? b.z() : a.z()); };
  constexpr int corners[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  Faces faces;
  for (const auto& face : corners) faces.push_back({at(face[0]), at(face[1]), at(face[2]), at(face[3])});
  return faces;
}

/// What of a polygon lies below the plane; the points where it is cut, or only touched, are added to `rim`.
Polygon below(const Polygon& polygon, const Vec3& point, const Vec3& normal, Polygon& rim) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double over_a = normal.dot(a - point), over_b = normal.dot(b - point);
    if (over_a <= 0) kept.push_back(a);
    if (over_a == 0) rim.push_back(a);
    if (over_a * over_b < 0) {
      // From the same end for both faces that share the edge, so that both find the same point.
      const bool rising = over_a < 0;
      const Vec3 &low = rising ? a : b, &high = rising ? b : a;
      const double under = rising ? over_a : over_b, over = rising ? over_b : over_a;
      kept.push_back(low + (high - low) * (under / (under - over)));
      rim.push_back(kept.back());
    }
  }
  return kept;
}

Faces cut(const Faces& faces, const Vec3& point, const Vec3& normal) {
  Faces kept;
  Polygon rim;
  for (const Polygon& face : faces)
    if (Polygon rest = below(face, point, normal, rim); rest.size() > 2) kept.push_back(std::move(rest));
  if (rim.empty()) return kept;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& corner : rim) middle += corner / static_cast<double>(rim.size());
  const Vec3 first = (rim.front() - middle).normalized(), second = normal.cross(first);
  const auto angle = [&](const Vec3& x) { return std::atan2((x - middle).dot(second), (x - middle).dot(first)); };
  std::sort(rim.begin(), rim.end(), [&](const Vec3& a, const Vec3& b) { return angle(a) < angle(b); });
  rim.erase(std::unique(rim.begin(), rim.end()), rim.end());  // each corner comes from two faces or more
  if (rim.size() > 2) kept.push_back(std::move(rim));
  return kept;
}

TetMesh meshed(const Faces& faces) {
  std::vector<Vec3> corners;
  std::vector<std::vector<int>> numbered;
  for (const Polygon& face : faces) {
    std::vector<int>& numbers = numbered.emplace_back();
    for (const Vec3& corner : face) {
      const auto known = std::find(corners.begin(), corners.end(), corner);
      numbers.push_back(static_cast<int>(known - corners.begin()));
      if (known == corners.end()) corners.push_back(corner);
    }
  }
  return convex_mesh(corners, numbered);
}

/// Cells by their faces, a point each.
std::vector<Faces> voronoi_cells(const Vec3& min, const Vec3& max, int count, unsigned seed) {
  std::mt19937 random(seed);  // its numbers are laid down by the standard, those of distributions are not
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Vec3> seeds;
  for (int i = 0; i < count; ++i) {
    const double x = share(), y = share(), z = share();
    seeds.push_back(min + Vec3(x, y, z).cwiseProduct(max - min));
  }
  std::vector<Faces> cells;
  for (int i = 0; i < count; ++i) {
    Faces cell = box_faces(min, max);
    for (int j = 0; j < count; ++j)
      if (j != i) cell = cut(cell, (seeds[i] + seeds[j]) / 2, (seeds[j] - seeds[i]).normalized());
    cells.push_back(std::move(cell));
  }
  return cells;
}

}  // namespace

std::vector<TetMesh> voronoi_pieces(const Vec3& min, const Vec3& max, int count, unsigned seed) {
  std::vector<TetMesh> pieces;
  for (const Faces& cell : voronoi_cells(min, max, count, seed)) pieces.push_back(meshed(cell));
  return pieces;
}

std::vector<TetMesh> voronoi_pieces(const Vec3& min, const Vec3& max, int count, unsigned seed,
                                    const CuttingPlane& plane) {
  constexpr std::size_t fewest_faces = 4;
  std::vector<TetMesh> pieces;
  for (const Faces& cell : voronoi_cells(min, max, count, seed))
    if (const Faces rest = cut(cell, plane.point, plane.normal); rest.size() >= fewest_faces)
      pieces.push_back(meshed(rest));
  return pieces;
}

}  // namespace talus
