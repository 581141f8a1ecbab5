#include "geometry/solid_surface.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "geometry/mesher_answers.hpp"
#include "geometry/mesher_solids.hpp"
#include "mesh/polygon_triangles.hpp"
#include "model/polyhedron.hpp"

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

/// As the mesher reads them: a surface for each solid, in their order; polyhedra are left empty.
std::vector<SolidSurface> surfaces_by_mesher(const MesherJob& job, Progress& progress) {
  MesherProcess mesher(MessageKind::look, to_bytes(job));
  MesherAnswers answers(mesher, progress, "export the solid again, in another format if need be");
  std::vector<SolidSurface> surfaces;
  for (;;) {
    const auto message = answers.next();
    if (message.kind == MessageKind::end) return surfaces;
    surfaces.push_back(from_bytes<SolidSurface>(message.bytes));
  }
}

std::vector<SolidSurface> surfaces_of(const std::vector<Solid>& solids, const Vec3& origin,
                                      const std::filesystem::path& folder, Progress& progress) {
  MesherJob job;
  job.solids = mesher_solids(solids, origin, folder);
  const auto is_polyhedron = [](const MesherSolid& solid) { return !solid.polyhedron.faces.empty(); };
  std::vector<SolidSurface> surfaces(job.solids.size());
  if (!std::all_of(job.solids.begin(), job.solids.end(), is_polyhedron)) surfaces = surfaces_by_mesher(job, progress);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!is_polyhedron(job.solids[i])) continue;
    surfaces[i] = surface_of(job.solids[i].polyhedron);
    surfaces[i].name = job.solids[i].name;
    surfaces[i].is_part = job.solids[i].is_part;
  }
  return surfaces;
}

}  // namespace

std::vector<SolidSurface> solid_surfaces(const Project& project, const std::filesystem::path& folder,
                                         Progress& progress) {
  return surfaces_of(project.solids, project.origin, folder, progress);
}

SolidSurface solid_surface(const Solid& solid, const Vec3& origin, const std::filesystem::path& folder,
                           Progress& progress) {
  return surfaces_of({solid}, origin, folder, progress).front();
}

}  // namespace talus
