#include "report/contact_planes.hpp"

#include <algorithm>
#include <functional>

#include "mesh/block_faces.hpp"

namespace talus::report {

namespace {

/// That of the cut that both lie on, of the interface that the project names, or the default.
std::string joint_between(const FlatFace& one, const FlatFace& other, const BlockSystem& system,
                          const Project& project) {
  if (one.joint >= 0 && one.joint == other.joint) return system.joint_names[static_cast<std::size_t>(one.joint)];
  const std::string& a = system.blocks[static_cast<std::size_t>(one.block)].name;
  const std::string& b = system.blocks[static_cast<std::size_t>(other.block)].name;
  for (const Interface& interface : project.interfaces)
    if (interface.between == std::array{a, b} || interface.between == std::array{b, a}) return interface.joint;
  return project.default_joint;
}

}  // namespace

std::vector<ContactPlane> contact_planes(const BlockSystem& system, const Project& project) {
  const BlockFaces found = block_faces(system);
  std::vector<ContactPlane> planes;
  for (const SharedFace& shared : found.shared) {
    const FlatFace& one = found.faces[static_cast<std::size_t>(shared.face)];
    const FlatFace& other = found.faces[static_cast<std::size_t>(shared.other)];
    const Block& first = system.blocks[static_cast<std::size_t>(one.block)];
    const Block& second = system.blocks[static_cast<std::size_t>(other.block)];
    if (first.body == BodyKind::fixed && second.body == BodyKind::fixed) continue;
    planes.push_back({joint_between(one, other, system, project),
                      {first.name, second.name},
                      attitude_of_normal(one.normal),
                      shared.area});
  }
  std::ranges::stable_sort(planes, std::greater{}, &ContactPlane::area);
  return planes;
}

}  // namespace talus::report
