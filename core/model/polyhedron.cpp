#include "model/polyhedron.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <Eigen/Geometry>

#include "model/number_text.hpp"
#include "model/require.hpp"

namespace talus {
namespace {

/// Coordinates given to the millimetre on a slope of a hundred metres are still planar.
constexpr double planarity = 1e-5;
/// A face whose area is below this part of the extent squared has no direction that could be trusted.
constexpr double smallest_area = 1e-12;

double largest_extent(const PolyhedronShape& shape) {
  Vec3 low = shape.vertices.front(), high = low;
  for (const auto& vertex : shape.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  return (high - low).maxCoeff();
}

void check_vertices(const PolyhedronShape& shape, const Place& place) {
  require(shape.vertices.size() >= 4, place / "vertices",
          "a polyhedron needs at least 4 vertices, has " + std::to_string(shape.vertices.size()),
          "add the missing ones");
  std::map<std::tuple<double, double, double>, std::size_t> seen;
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const Vec3& vertex = shape.vertices[i];
    require_finite(vertex, place / "vertices" / i);
    const auto [first, fresh] = seen.try_emplace({vertex[0], vertex[1], vertex[2]}, i);
    require(fresh, place / "vertices" / i, "is the same point as vertex " + std::to_string(first->second),
            "use vertex " + std::to_string(first->second) + " in the faces and remove this one");
  }
}

void check_face_numbers(const PolyhedronShape& shape, const Place& place) {
  const auto count = static_cast<int>(shape.vertices.size());
  require(shape.faces.size() >= 4, place / "faces",
          "a polyhedron needs at least 4 faces, has " + std::to_string(shape.faces.size()), "add the missing ones");
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const auto& face = shape.faces[f];
    const Place here = place / "faces" / f;
    require(face.size() >= 3, here, "a face needs at least 3 vertices", "add the missing ones or remove the face");
    std::set<int> used;
    for (std::size_t i = 0; i < face.size(); ++i) {
      require(face[i] >= 0 && face[i] < count, here / i, "there is no vertex " + std::to_string(face[i]),
              "use 0 to " + std::to_string(count - 1) + "; vertices are counted from 0");
      require(used.insert(face[i]).second, here, "uses vertex " + std::to_string(face[i]) + " twice",
              "name each vertex of a face once");
    }
  }
}

void check_planes(const PolyhedronShape& shape, const Place& place) {
  const double size = largest_extent(shape);
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const auto& face = shape.faces[f];
    const Place here = place / "faces" / f;
    const Vec3 area = doubled_area(shape, face);
    require(area.norm() > smallest_area * size * size, here, "the face has no area: its vertices lie on one line",
            "move a vertex or remove the face");
    const Vec3 normal = area.normalized();
    Vec3 centre = Vec3::Zero();
    for (const int vertex : face) centre += shape.vertices[vertex] / static_cast<double>(face.size());
    double off = 0;
    for (const int vertex : face) off = std::max(off, std::abs(normal.dot(shape.vertices[vertex] - centre)));
    require(off <= planarity * size, here, "the face is not plane: a vertex lies " + number_text(off) + " m off it",
            "split the face into triangles or mend the vertices");
  }
}

std::string edge_text(const std::pair<int, int>& edge) {
  return std::to_string(edge.first) + "–" + std::to_string(edge.second);
}

void check_closed(const PolyhedronShape& shape, const Place& place) {
  std::map<std::pair<int, int>, std::size_t> face_of;  // by directed edge
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const auto& face = shape.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::pair edge{face[i], face[(i + 1) % face.size()]};
      const auto [other, fresh] = face_of.try_emplace(edge, f);
      require(fresh, place / "faces" / f,
              "runs along edge " + edge_text(edge) + " in the same direction as face " + std::to_string(other->second),
              "list the vertices of every face counter-clockwise seen from outside; an edge joins two faces");
    }
  }
  for (const auto& [edge, face] : face_of) {
    require(face_of.contains({edge.second, edge.first}), place / "faces" / face,
            "the polyhedron is open: no other face joins edge " + edge_text(edge),
            "add the missing face, or let its neighbour use the same two vertices");
  }
}

}  // namespace

Vec3 doubled_area(const PolyhedronShape& shape, const std::vector<int>& face) {
  const Vec3 origin = shape.vertices[face[0]];
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    sum += (shape.vertices[face[i]] - origin).cross(shape.vertices[face[i + 1]] - origin);
  }
  return sum;
}

double signed_volume(const PolyhedronShape& shape) {
  const Vec3 origin = shape.vertices.front();
  double sum = 0;
  for (const auto& face : shape.faces) {
    sum += doubled_area(shape, face).dot(shape.vertices[face[0]] - origin);
  }
  return sum / 6;
}

void validate_polyhedron(const PolyhedronShape& shape, const Place& place) {
  check_vertices(shape, place);
  check_face_numbers(shape, place);
  check_planes(shape, place);
  check_closed(shape, place);
  const double volume = signed_volume(shape);
  require(volume > 0, place, "the polyhedron is inside out: its volume comes to " + number_text(volume) + " m³",
          "reverse the order of the vertices in every face: counter-clockwise seen from outside");
}

}  // namespace talus
