#include "geometry/mesher/polyhedron.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/error.hpp"

namespace talus {
namespace {

using DirectedEdge = std::pair<int, int>;

double longest_side(const PolyhedronShape& shape) {
  Eigen::AlignedBox3d bounds;
  for (const Vec3& vertex : shape.vertices) bounds.extend(vertex);
  return bounds.sizes().maxCoeff();
}

std::string face_name(std::size_t face) { return "face " + std::to_string(face); }

void check_single_body(const PolyhedronShape& shape, const std::string& place) {
  std::map<DirectedEdge, int> owner;  // the face that runs along it
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    const std::vector<int>& face = shape.faces[f];
    for (std::size_t k = 0; k < face.size(); ++k) {
      owner.emplace(DirectedEdge{face[k], face[(k + 1) % face.size()]}, static_cast<int>(f));
    }
  }
  std::vector<bool> reached(shape.faces.size(), false);
  std::vector<int> open{0};
  reached[0] = true;
  while (!open.empty()) {
    const std::vector<int>& face = shape.faces[static_cast<std::size_t>(open.back())];
    open.pop_back();
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int neighbour = owner.at({face[(k + 1) % face.size()], face[k]});
      if (reached[static_cast<std::size_t>(neighbour)]) continue;
      reached[static_cast<std::size_t>(neighbour)] = true;
      open.push_back(neighbour);
    }
  }
  const auto missed = std::find(reached.begin(), reached.end(), false);
  if (missed != reached.end()) {
    throw InputError(place, face_name(static_cast<std::size_t>(missed - reached.begin())) + " is not joined to face 0",
                     "make each separate body a solid of its own");
  }
}

/// Twice the area along the normal (Newell), about a vertex of the face so that far coordinates cost no digits.
Plane fitted_plane(const PolyhedronShape& shape, const std::vector<int>& face) {
  const auto vertex = [&](std::size_t k) -> const Vec3& {
    return shape.vertices[static_cast<std::size_t>(face[k % face.size()])];
  };
  const Vec3 origin = vertex(0);
  Vec3 area = Vec3::Zero(), centre = Vec3::Zero();
  for (std::size_t k = 0; k < face.size(); ++k) {
    area += (vertex(k) - origin).cross(vertex(k + 1) - origin);
    centre += vertex(k) - origin;
  }
  const Vec3 normal = area.normalized();
  return {normal, normal.dot(origin) + normal.dot(centre) / static_cast<double>(face.size())};
}

struct Unflatness {
  double distance = 0;
  std::size_t face = 0;
};

Unflatness largest_unflatness(const PolyhedronShape& shape, const std::vector<Plane>& planes) {
  Unflatness worst;
  for (std::size_t f = 0; f < planes.size(); ++f) {
    for (int v : shape.faces[f]) {
      const double distance = std::abs(planes[f].distance(shape.vertices[static_cast<std::size_t>(v)]));
      if (distance > worst.distance) worst = {distance, f};
    }
  }
  return worst;
}

std::vector<Plane> fitted_planes(const PolyhedronShape& shape) {
  std::vector<Plane> planes;
  for (const std::vector<int>& face : shape.faces) planes.push_back(fitted_plane(shape, face));
  return planes;
}

}  // namespace

/// Turn by turn fits a plane to each face and moves each vertex onto the planes of its faces with more than three
/// vertices (a triangle is always flat).
PolyhedronShape with_flat_faces(PolyhedronShape shape, const std::string& place) {
  constexpr double flat = 1e-13;  // of the longest side
  constexpr int turns = 500;
  const double size = longest_side(shape);
  std::vector<Plane> planes = fitted_planes(shape);
  Unflatness worst = largest_unflatness(shape, planes);
  const auto not_flat = [&] {
    return InputError(place,
                      face_name(worst.face) + " is not flat: its vertices lie up to " + std::to_string(worst.distance) +
                          " m off a plane",
                      "correct them or split the face into triangles");
  };
  const Unflatness first = worst;
  for (int turn = 0; turn < turns && worst.distance > flat * size; ++turn) {
    for (std::size_t v = 0; v < shape.vertices.size(); ++v) {
      std::vector<Plane> through;
      for (std::size_t f = 0; f < planes.size(); ++f) {
        const std::vector<int>& face = shape.faces[f];
        if (face.size() > 3 && std::find(face.begin(), face.end(), static_cast<int>(v)) != face.end()) {
          through.push_back(planes[f]);
        }
      }
      shape.vertices[v] = nearest_common_point(through, shape.vertices[v]);
    }
    planes = fitted_planes(shape);
    worst = largest_unflatness(shape, planes);
  }
  constexpr double settled = 1e-10;
  if (worst.distance > settled * size) {
    worst = first;
    throw not_flat();
  }
  return shape;
}

PolyhedronShape flattened(PolyhedronShape shape, const std::string& place) {
  check_single_body(shape, place);
  return with_flat_faces(std::move(shape), place);
}

Plane plane_of(const PolyhedronShape& shape, const std::vector<int>& face) { return fitted_plane(shape, face); }

bool is_convex(const PolyhedronShape& shape) {
  constexpr double rounding = 1e-9;  // of the longest side
  const double size = longest_side(shape), reach = rounding * size;
  const auto at = [&](int v) -> const Vec3& { return shape.vertices[static_cast<std::size_t>(v)]; };
  return std::all_of(shape.faces.begin(), shape.faces.end(), [&](const std::vector<int>& face) {
    const Plane plane = fitted_plane(shape, face);
    for (const Vec3& vertex : shape.vertices)
      if (plane.distance(vertex) > reach) return false;
    // Each edge has the whole face on its left.
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vec3& from = at(face[k]);
      const Vec3 inwards = plane.normal.cross(at(face[(k + 1) % face.size()]) - from);
      for (const int v : face)
        if (inwards.dot(at(v) - from) < -reach * inwards.norm()) return false;
    }
    return true;
  });
}

}  // namespace talus
