#include "geometry/mesher/surfaces/triangle_solid.hpp"

namespace talus {

double volume_of(const TriangleSolid& solid) {
  if (solid.empty()) return 0;
  const Vec3 middle = bounds_of(solid).center();  // far coordinates cost no digits
  const auto at = [&](int v) -> Vec3 { return solid.vertices[static_cast<std::size_t>(v)] - middle; };
  double sixfold = 0;
  for (const auto& [a, b, c] : solid.triangles) sixfold += at(a).dot(at(b).cross(at(c)));
  return sixfold / 6;
}

Eigen::AlignedBox3d bounds_of(const TriangleSolid& solid) {
  Eigen::AlignedBox3d bounds;
  for (const Vec3& vertex : solid.vertices) bounds.extend(vertex);
  return bounds;
}

}  // namespace talus
