#include "geometry/mesher/surfaces/surface_boolean.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include "base/error.hpp"

namespace talus {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using ExactPoint = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
using ExactMesh = CGAL::Surface_mesh<ExactPoint>;

ExactMesh mesh_of(const TriangleSolid& solid) {
  ExactMesh mesh;
  std::vector<ExactMesh::Vertex_index> vertices;
  for (const Vec3& vertex : solid.vertices)
    vertices.push_back(mesh.add_vertex(ExactPoint(vertex.x(), vertex.y(), vertex.z())));
  const auto at = [&](int v) { return vertices[static_cast<std::size_t>(v)]; };
  for (const auto& [a, b, c] : solid.triangles) mesh.add_face(at(a), at(b), at(c));
  return mesh;
}

PolygonSoup soup_of(const ExactMesh& mesh) {
  PolygonSoup soup;
  for (const auto v : mesh.vertices()) {
    const ExactPoint& point = mesh.point(v);
    soup.points.emplace_back(CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z()));
  }
  for (const auto face : mesh.faces()) {
    std::vector<int> polygon;
    for (const auto v : vertices_around_face(mesh.halfedge(face), mesh)) polygon.push_back(static_cast<int>(v.idx()));
    soup.polygons.push_back(std::move(polygon));
  }
  return soup;
}

/// False when the result would meet itself in a line or a point.
bool combine(CombineOperation operation, ExactMesh& first, ExactMesh& second, ExactMesh& result) {
  switch (operation) {
    case CombineOperation::subtract:
      return pmp::corefine_and_compute_difference(first, second, result);
    case CombineOperation::intersect:
      return pmp::corefine_and_compute_intersection(first, second, result);
    case CombineOperation::unite:
      break;
  }
  return pmp::corefine_and_compute_union(first, second, result);
}

}  // namespace

MendedSurface combined(CombineOperation operation, const std::vector<TriangleSolid>& parts, const std::string& place) {
  ExactMesh sum = mesh_of(parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) {
    ExactMesh next = mesh_of(parts[i]), result;
    if (!combine(operation, sum, next, result))
      throw InputError(place, "its parts touch in a line or a point alone", "move one of them a little");
    result.collect_garbage();
    sum = std::move(result);
    if (sum.number_of_faces() == 0)
      throw InputError(place, "nothing is left of it", "move its parts so that they share rock");
  }
  return mended(soup_of(sum));
}

}  // namespace talus
