#include "model/solid_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/units.hpp"

namespace talus {
namespace {

/// The faces of a prism: its two ends have the same corners in the same order, counter-clockwise seen from the end
/// that `top` is.
PolyhedronShape prism(const std::vector<Vec3>& bottom, const std::vector<Vec3>& top) {
  const int n = static_cast<int>(bottom.size());
  PolyhedronShape shape{bottom, {}};
  shape.vertices.insert(shape.vertices.end(), top.begin(), top.end());
  std::vector<int> below(bottom.size()), above(bottom.size());
  std::iota(below.rbegin(), below.rend(), 0);
  std::iota(above.begin(), above.end(), n);
  shape.faces = {below, above};
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    shape.faces.push_back({i, next, n + next, n + i});
  }
  return shape;
}

PolyhedronShape faces_of(const BoxShape& box) {
  PolyhedronShape shape;
  for (int corner = 0; corner < 8; ++corner) {
    shape.vertices.emplace_back(corner & 1 ? box.max.x() : box.min.x(), corner & 2 ? box.max.y() : box.min.y(),
                                corner & 4 ? box.max.z() : box.min.z());
  }
  shape.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return shape;
}

PolyhedronShape faces_of(const CylinderShape& cylinder) {
  const Vec3 axis = (cylinder.to - cylinder.from).normalized();
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Vec3> bottom, top;
  for (int i = 0; i < cylinder.sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / cylinder.sides;
    const Vec3 arm = cylinder.radius * (std::cos(angle) * u + std::sin(angle) * v);
    bottom.push_back(cylinder.from + arm);
    top.push_back(cylinder.to + arm);
  }
  return prism(bottom, top);
}

double twice_the_area(const std::vector<std::array<double, 2>>& points) {
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &a = points[i], &b = points[(i + 1) % points.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

PolyhedronShape faces_of(const SectionShape& section) {
  const double azimuth = radians(section.azimuth);
  // Distance, height and across are a right-handed frame: counter-clockwise corners are so seen from across.
  const Vec3 along(std::sin(azimuth), std::cos(azimuth), 0), across = along.cross(Vec3::UnitZ());
  std::vector<std::array<double, 2>> points = section.points;
  if (twice_the_area(points) < 0) std::reverse(points.begin(), points.end());
  std::vector<Vec3> bottom, top;
  for (const auto& [distance, height] : points) {
    const Vec3 corner = section.origin + distance * along + height * Vec3::UnitZ();
    bottom.push_back(corner - section.width / 2 * across);
    top.push_back(corner + section.width / 2 * across);
  }
  return prism(bottom, top);
}

}  // namespace

const std::string* file_of(const SolidShape& shape) {
  if (const auto* file = std::get_if<FileShape>(&shape)) return &file->path;
  if (const auto* terrain = std::get_if<TerrainShape>(&shape)) return &terrain->path;
  return nullptr;
}

std::string* file_of(SolidShape& shape) {
  return const_cast<std::string*>(file_of(std::as_const(shape)));  // the shape itself may be changed
}

Vec3 placed(const Solid& solid, const Vec3& point) {
  if (!solid.turn) return point + solid.move;
  const Turn& turn = *solid.turn;
  const Eigen::AngleAxisd rotation(radians(turn.angle), turn.axis.normalized());
  return turn.about + rotation * (point - turn.about) + solid.move;
}

std::optional<PolyhedronShape> polyhedron_of(const Solid& solid) {
  PolyhedronShape shape;
  if (const auto* box = std::get_if<BoxShape>(&solid.shape))
    shape = faces_of(*box);
  else if (const auto* polyhedron = std::get_if<PolyhedronShape>(&solid.shape))
    shape = *polyhedron;
  else if (const auto* cylinder = std::get_if<CylinderShape>(&solid.shape))
    shape = faces_of(*cylinder);
  else if (const auto* section = std::get_if<SectionShape>(&solid.shape))
    shape = faces_of(*section);
  else
    return std::nullopt;
  for (Vec3& vertex : shape.vertices) vertex = placed(solid, vertex);
  return shape;
}

std::optional<BoxShape> extent_of(const std::vector<Solid>& solids) {
  std::optional<BoxShape> extent;
  for (const Solid& solid : solids) {
    const auto shape = polyhedron_of(solid);
    if (!shape) continue;
    for (const Vec3& vertex : shape->vertices) {
      if (!extent) extent = BoxShape{vertex, vertex};
      extent->min = extent->min.cwiseMin(vertex);
      extent->max = extent->max.cwiseMax(vertex);
    }
  }
  return extent;
}

}  // namespace talus
