#include "measures/block_travel.hpp"

#include <Eigen/Geometry>

#include "base/units.hpp"
#include "bodies/block_pose.hpp"

namespace talus {

double BlockTravel::turn() const { return degrees(Eigen::AngleAxisd(rotation).angle()); }

std::vector<BlockTravel> block_travels(const BlockSystem& system, const Frame& frame) {
  const PoseFit fit(system);
  std::vector<BlockTravel> travels;
  std::size_t first = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const int number = static_cast<int>(b);
    const std::vector<Vec3>& rest = system.blocks[b].mesh.nodes;
    std::vector<Vec3> moved = rest;
    for (std::size_t n = 0; n < rest.size(); ++n) moved[n] += frame.displacement[first + n];
    BlockTravel& travel = travels.emplace_back();
    travel.block = number;
    if (!rest.empty()) {
      const BlockPose pose = fit.pose(number, rest.data(), moved.data());
      travel.centroid = pose.centroid;
      travel.rotation = pose.rotation;
      travel.displacement = fit.mean(number, &frame.displacement[first]);
      travel.velocity = fit.mean(number, &frame.velocity[first]);
    }
    first += rest.size();
  }
  return travels;
}

}  // namespace talus
