#include "geometry/mesher/facet.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/units.hpp"

namespace talus {
namespace {

void append_curve(int tag, std::vector<Vec3>& points) {
  std::string type;
  gmsh::model::getType(1, tag, type);
  const int pieces = type == "Line" ? 1 : 8;
  std::vector<double> low, high, parameters, coordinates;
  gmsh::model::getParametrizationBounds(1, tag, low, high);
  for (int k = 0; k <= pieces; ++k) parameters.push_back(low[0] + (high[0] - low[0]) * k / pieces);
  gmsh::model::getValue(1, tag, parameters, coordinates);
  for (std::size_t k = 0; k + 2 < coordinates.size(); k += 3) {
    points.emplace_back(coordinates[k], coordinates[k + 1], coordinates[k + 2]);
  }
}

Plane plane_of_flat_face(int tag, const std::vector<Vec3>& outline) {
  std::vector<double> low, high, normal;
  gmsh::model::getParametrizationBounds(2, tag, low, high);
  gmsh::model::getNormal(tag, {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2}, normal);
  const Vec3 direction = cleaned_direction({normal[0], normal[1], normal[2]});
  double offset = 0;
  for (const Vec3& point : outline) offset += direction.dot(point);
  return {direction, offset / static_cast<double>(outline.size())};
}

}  // namespace

Facet read_facet(int tag) {
  Facet facet{tag, {}, {}};
  gmsh::vectorpair curves;
  gmsh::model::getBoundary({{2, tag}}, curves, false, false, false);
  for (const auto& [dimension, curve] : curves) append_curve(curve, facet.outline);
  std::string type;
  gmsh::model::getType(2, tag, type);
  if (type == "Plane") facet.plane = plane_of_flat_face(tag, facet.outline);
  return facet;
}

double area_of(int tag) {
  double area = 0;
  gmsh::model::occ::getMass(2, tag, area);
  return area;
}

std::vector<int> faces_of(const std::vector<int>& volumes) {
  gmsh::vectorpair owners, faces;
  for (int tag : volumes) owners.emplace_back(3, tag);
  gmsh::model::getBoundary(owners, faces, false, false, false);
  std::set<int> distinct;
  for (const auto& [dimension, tag] : faces) distinct.insert(std::abs(tag));
  return {distinct.begin(), distinct.end()};
}

bool lies_on(const Plane& plane, const Facet& facet, double reach) {
  constexpr double splinter_angle = radians(0.1);
  if (!facet.plane || angle_between(plane, *facet.plane) > splinter_angle) return false;
  double lowest = plane.distance(facet.outline.front()), highest = lowest;
  for (const Vec3& point : facet.outline) {
    lowest = std::min(lowest, plane.distance(point));
    highest = std::max(highest, plane.distance(point));
  }
  return lowest <= reach && highest >= -reach;
}

Eigen::AlignedBox3d bounds_of_volume(int tag) {
  Vec3 low, high;
  gmsh::model::occ::getBoundingBox(3, tag, low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
  return {low, high};
}

Bulk bulk_of_volume(int tag) {
  Bulk bulk;
  gmsh::model::occ::getMass(3, tag, bulk.volume);
  gmsh::model::occ::getCenterOfMass(3, tag, bulk.centroid.x(), bulk.centroid.y(), bulk.centroid.z());
  return bulk;
}

Measure measure_volume(int tag) {
  Measure measure{bulk_of_volume(tag)};
  for (int face : faces_of({tag})) measure.area += area_of(face);
  return measure;
}

}  // namespace talus
