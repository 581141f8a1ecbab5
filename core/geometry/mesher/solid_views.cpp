#include "geometry/mesher/solid_views.hpp"

#include <utility>

#include "geometry/mesher/occ_volumes.hpp"
#include "geometry/mesher/surfaces/planar_faces.hpp"

namespace talus {
namespace {

bool is_closed(const std::vector<SurfaceFinding>& findings) {
  for (const SurfaceFinding& finding : findings)
    if (finding.kind == SurfaceFinding::Kind::hole && !finding.mended) return false;
  return true;
}

}  // namespace

SolidSurface surface_of(const MesherSolid& solid, const ImportedSolid& imported, const Vec3& origin) {
  TriangleSolid triangles = imported.volumes.empty() ? imported.triangles : tessellated(imported.volumes);
  SolidSurface surface;
  surface.name = solid.name;
  surface.is_part = solid.is_part;
  surface.findings = imported.findings;
  surface.closed = is_closed(imported.findings);
  surface.volume = surface.closed ? imported.volume : 0;
  const Eigen::AlignedBox3d bounds = bounds_of(triangles);
  surface.min = bounds.min() + origin;
  surface.max = bounds.max() + origin;
  surface.edges = feature_edges(triangles);
  surface.vertices = std::move(triangles.vertices);
  for (Vec3& vertex : surface.vertices) vertex += origin;
  surface.triangles = std::move(triangles.triangles);
  return surface;
}

}  // namespace talus
