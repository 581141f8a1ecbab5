#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/rock/cut.hpp"
#include "render/scene/joint_face.hpp"

namespace talus {

/// A solid that joints are drawn in.
struct JointedRock {
  std::string name;
  std::shared_ptr<const SurfaceTree> surface;  ///< with all points of the solid's, thinned where it has many triangles
};

/// What of a cut lies in the rock: its planes, discs or polygons, or the discs of its network, as far as they are in
/// the solids that it is limited to, and on their own side of the cuts where they end. Takes long for networks alone.
JointFace drawn_joint(const Cut& cut, const std::vector<Cut>& ends, const std::vector<JointedRock>& rock);

}  // namespace talus
