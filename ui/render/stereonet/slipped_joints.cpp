#include "render/stereonet/slipped_joints.hpp"

namespace talus {

std::vector<MeasuredJoint> joints_that_slipped(std::span<const SlippedFace> faces,
                                               const std::vector<std::string>& joint_names) {
  std::vector<MeasuredJoint> joints;
  for (const SlippedFace& face : faces) {
    const auto joint = static_cast<std::size_t>(face.joint);
    const bool is_named = face.joint >= 0 && joint < joint_names.size();
    joints.push_back({attitude_of_normal(face.normal), is_named ? joint_names[joint] : ""});
  }
  return joints;
}

}  // namespace talus
