#include "geometry/mesher/placement.hpp"

#include <gmsh.h>

#include <Eigen/Geometry>

namespace talus {

Vec3 placed(const MesherPlacement& placement, const Vec3& point) {
  const Vec3 local = point - placement.origin;
  if (placement.angle == 0) return local + placement.move;
  const Eigen::AngleAxisd rotation(placement.angle, placement.axis);
  return placement.about + rotation * (local - placement.about) + placement.move;
}

void place_volumes(const MesherPlacement& placement, const std::vector<int>& volumes) {
  namespace occ = gmsh::model::occ;
  gmsh::vectorpair shapes;
  for (const int tag : volumes) shapes.emplace_back(3, tag);
  const auto shift = [&](const Vec3& by) {
    if (!by.isZero(0)) occ::translate(shapes, by.x(), by.y(), by.z());
  };
  shift(-placement.origin);
  if (placement.angle != 0)
    occ::rotate(shapes, placement.about.x(), placement.about.y(), placement.about.z(), placement.axis.x(),
                placement.axis.y(), placement.axis.z(), placement.angle);
  shift(placement.move);
}

MesherPlacement relative_to(const Vec3& origin, MesherPlacement placement) {
  placement.origin.setZero();
  placement.about -= origin;
  return placement;
}

}  // namespace talus
