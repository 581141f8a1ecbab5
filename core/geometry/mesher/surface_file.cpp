#include "geometry/mesher/surface_file.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "geometry/mesher/mesh_file.hpp"
#include "geometry/mesher/placement.hpp"
#include "geometry/mesher/surfaces/height_field.hpp"
#include "geometry/mesher/surfaces/height_points.hpp"
#include "geometry/mesher/surfaces/triangle_file.hpp"
#include "model/number_text.hpp"

namespace talus {
namespace {

bool has_ending(const MesherSolid& solid, const std::set<std::string>& endings) {
  return endings.contains(ending_of(solid.file));
}

bool has_triangles(const MesherSolid& solid) { return has_ending(solid, {".stl", ".obj", ".ply", ".msh"}); }

/// In metres, as the file has them.
PolygonSoup polygons_of(const MesherSolid& solid) {
  PolygonSoup soup = ending_of(solid.file) == ".msh" ? read_mesh(solid.file, solid.file_as_written)
                                                     : read_polygons(solid.file, solid.file_as_written);
  for (Vec3& point : soup.points) point *= solid.scale;
  return soup;
}

MendedSurface closed_surface(const MesherSolid& solid) {
  PolygonSoup soup = polygons_of(solid);
  for (Vec3& point : soup.points) point = placed(solid.placement, point);
  MendedSurface surface = mended(soup);
  if (surface.surface.empty())
    throw InputError(solid.file_as_written, "all of its faces are without area", "export the surface again");
  return surface;
}

/// A number that stands for no height, or one that was damaged, would be a needle that reaches out of the world.
/// `points` are less `origin`.
void require_on_earth(const std::vector<Vec3>& points, const MesherSolid& solid) {
  constexpr double highest = 1e6, farthest = 1e8;  // m
  for (const Vec3& point : points) {
    const Vec3 at = point + solid.placement.origin;
    if (std::abs(at.z()) <= highest && std::abs(at.x()) <= farthest && std::abs(at.y()) <= farthest) continue;
    const std::string place = significant(at.x()) + ", " + significant(at.y()) + ", " + significant(at.z());
    throw InputError(solid.file_as_written, "has a point at (" + place + "), which is nowhere on Earth",
                     "correct it, mark numbers that stand for no height as such, and give coordinates in metres");
  }
}

/// The surface of a terrain, in the project's coordinates, before it is turned and moved.
HeightField heights_of(const MesherSolid& solid, std::vector<SurfaceFinding>& findings) {
  const Vec3& origin = solid.placement.origin;
  if (has_triangles(solid)) {
    PolygonSoup soup = polygons_of(solid);
    for (Vec3& point : soup.points) point -= origin;
    require_on_earth(soup.points, solid);
    return height_field(welded(soup), solid.terrain->tolerance, solid.file_as_written);
  }
  HeightPoints read = has_ending(solid, {".asc", ".tif", ".tiff"})
                          ? read_grid(solid.file, solid.file_as_written, origin)
                          : read_points(solid.file, solid.file_as_written, origin);
  require_on_earth(read.points, solid);
  findings = std::move(read.findings);
  return height_field(read.points, solid.terrain->tolerance, solid.file_as_written);
}

MendedSurface terrain(const MesherSolid& solid) {
  MendedSurface result;
  result.surface = solid_below(heights_of(solid, result.findings), solid.terrain->base, "solid " + solid.name);
  const MesherPlacement placement = relative_to(Vec3::Zero(), solid.placement);
  for (Vec3& vertex : result.surface.vertices) vertex = placed(placement, vertex);
  return result;
}

}  // namespace

bool has_surface_file(const MesherSolid& solid) {
  return !solid.file.empty() && (solid.terrain || has_triangles(solid));
}

MendedSurface read_surface(const MesherSolid& solid) { return solid.terrain ? terrain(solid) : closed_surface(solid); }

}  // namespace talus
