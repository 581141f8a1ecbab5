#include "geometry/solid_surface.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "geometry/polygon_triangles.hpp"
#include "model/polyhedron.hpp"
#include "model/solid_shape.hpp"

namespace talus {
namespace {

SolidSurface surface_of(const PolyhedronShape& shape) {
  SolidSurface surface;
  std::set<std::array<int, 2>> edges;
  for (const std::vector<int>& face : shape.faces) {
    const auto triangles = polygon_triangles(shape.vertices, face);
    surface.triangles.insert(surface.triangles.end(), triangles.begin(), triangles.end());
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto [a, b] = std::minmax(face[k], face[(k + 1) % face.size()]);
      edges.insert({a, b});
    }
  }
  surface.edges.assign(edges.begin(), edges.end());
  surface.vertices = shape.vertices;
  surface.volume = signed_volume(shape);
  surface.closed = true;
  surface.min = surface.max = shape.vertices.front();
  for (const Vec3& vertex : shape.vertices) {
    surface.min = surface.min.cwiseMin(vertex);
    surface.max = surface.max.cwiseMax(vertex);
  }
  return surface;
}

}  // namespace

SolidSurface solid_surface(const Solid& solid, const Vec3&, const std::filesystem::path&, Progress&) {
  const auto polyhedron = polyhedron_of(solid);
  if (!polyhedron)
    throw InputError("solid " + solid.name, "this version does not show such a solid", "cut the project to see it");
  SolidSurface surface = surface_of(*polyhedron);
  surface.name = solid.name;
  return surface;
}

std::vector<SolidSurface> solid_surfaces(const Project& project, const std::filesystem::path& folder,
                                         Progress& progress) {
  std::vector<SolidSurface> surfaces;
  for (const Solid& solid : project.solids) surfaces.push_back(solid_surface(solid, project.origin, folder, progress));
  return surfaces;
}

}  // namespace talus
