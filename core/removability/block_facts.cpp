#include "removability/block_facts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "base/units.hpp"
#include "mesh/moments.hpp"

namespace talus {

namespace {

int joint_named(const Project& project, const std::string& name) {
  const auto found = std::find_if(project.joints.begin(), project.joints.end(),
                                  [&](const Joint& joint) { return joint.name == name; });
  return found == project.joints.end() ? -1 : static_cast<int>(found - project.joints.begin());
}

/// Index into Project::joints; −1: none, which has no strength.
int joint_between(const Project& project, const BlockSystem& system, const FlatFace& one, const FlatFace& other) {
  if (one.joint >= 0 && one.joint == other.joint) return one.joint;
  const std::string &a = system.blocks[one.block].name, &b = system.blocks[other.block].name;
  std::string name = project.default_joint;
  for (const Interface& interface : project.interfaces)
    if ((interface.between[0] == a && interface.between[1] == b) ||
        (interface.between[0] == b && interface.between[1] == a))
      name = interface.joint;
  return joint_named(project, name);
}

/// What a block lies on in one direction: faces with one normal hold it as one plane.
struct Held {
  HoldingPlane plane;
  double area = 0;
  std::set<int> joints;
};

void hold(std::vector<Held>& holding, const Project& project, const Vec3& normal, double area, int joint) {
  auto one = std::find_if(holding.begin(), holding.end(), [&](const Held& held) {
    return (held.plane.normal - normal).squaredNorm() < same_normal * same_normal;
  });
  if (one == holding.end()) one = holding.insert(one, Held{{normal, 0, 0}, 0, {}});
  if (joint >= 0) {
    const Joint& law = project.joints[joint];
    const double friction = std::tan(radians(law.friction_angle));
    one->plane.friction = (one->plane.friction * one->area + friction * area) / (one->area + area);
    one->plane.cohesion += law.cohesion * area;
  } else {
    one->plane.friction *= one->area / (one->area + area);
  }
  one->area += area;
  one->joints.insert(joint);
}

std::string names_of(const std::set<int>& joints, const Project& project) {
  std::string names;
  for (const int joint : joints)
    if (joint >= 0) names += (names.empty() ? "" : " + ") + project.joints[joint].name;
  return names;
}

}  // namespace

double slenderness(const Block& block, double area) {
  Eigen::AlignedBox3d box;
  for (const Vec3& node : block.mesh.nodes) box.extend(node);
  return box.sizes().maxCoeff() * area / (3 * block.volume);
}

std::vector<BlockFacts> block_facts(const Project& project, const BlockSystem& system) {
  const BlockFaces all = block_faces(system);
  std::vector<BlockFacts> facts(system.blocks.size());
  std::vector<std::vector<Held>> holding(system.blocks.size());
  std::vector<double> covered(all.faces.size(), 0);
  std::vector<std::set<int>> neighbours(system.blocks.size()), joints(system.blocks.size());

  for (const SharedFace& shared : all.shared) {
    const FlatFace &one = all.faces[shared.face], &other = all.faces[shared.other];
    const int joint = joint_between(project, system, one, other);
    for (const auto& [face, opposite] : {std::pair(&one, &other), std::pair(&other, &one)}) {
      neighbours[face->block].insert(opposite->block);
      if (joint >= 0) joints[face->block].insert(joint);
      hold(holding[face->block], project, face->normal, shared.area, joint);
    }
    covered[shared.face] += shared.area;
    covered[shared.other] += shared.area;
  }
  for (std::size_t f = 0; f < all.faces.size(); ++f) {
    const FlatFace& face = all.faces[f];
    BlockFacts& block = facts[face.block];
    ++block.faces;
    block.free_faces += covered[f] == 0;
    block.area += face.area;
    block.free_area += std::max(0.0, face.area - covered[f]);
    if (face.joint >= 0) joints[face.block].insert(face.joint);
  }
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const Block& block = system.blocks[i];
    facts[i].neighbours.assign(neighbours[i].begin(), neighbours[i].end());
    facts[i].joints.assign(joints[i].begin(), joints[i].end());
    facts[i].centroid = volume_moments(block.mesh).centroid;
    facts[i].slenderness = slenderness(block, facts[i].area);
    facts[i].fixed = block.body == BodyKind::fixed;
    std::vector<HoldingPlane> planes;
    for (const Held& held : holding[i]) planes.push_back(held.plane);
    const Vec3 weight = project.materials[block.material].density * block.volume * project.gravity;
    facts[i].leaving = removability(planes, facts[i].free_faces > 0, weight);
    for (const int plane : facts[i].leaving.on)
      facts[i].slides_on.push_back(names_of(holding[i][plane].joints, project));
  }
  return facts;
}

}  // namespace talus
