#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "geometry/mesher/plane.hpp"
#include "geometry/mesher_job.hpp"

namespace talus {

/// A joint of a cut as it acts on one solid, relative to the model's origin.
struct ActingJoint {
  int cut = 0;    ///< index into MesherJob::cuts
  int index = 0;  ///< of the joint in its cut
  Plane plane;
  Vec3 through = Vec3::Zero();
  std::vector<Vec3> outline;  ///< corners in order, on the plane; empty: without end

  bool ends() const { return !outline.empty(); }
};

/// All joints of the cuts that act on a solid, cut by cut, those without end first. Joints that end at others are
/// clipped at the planes of these, on the side of their own point; at a joint that ends itself only where the two meet.
/// `bounds`: of the solid, m. Throws InputError for a joint whose point lies on the plane at which it is to end.
std::vector<ActingJoint> acting_joints(const MesherJob& job, int solid, const Vec3& origin,
                                       const Eigen::AlignedBox3d& bounds);

/// Four corners on the plane around the box.
std::vector<Vec3> square_around(const Plane& plane, const Eigen::AlignedBox3d& bounds);

}  // namespace talus
