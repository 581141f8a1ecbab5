#include "verification/hard_cases/elsewhere.hpp"

#include <algorithm>
#include <limits>

#include "verification/hard_cases/shapes.hpp"

namespace talus {

namespace {

Mat3 turn_to(const Elsewhere& place) { return turn_about(Vec3::UnitZ(), place.azimuth); }

}  // namespace

void place_scene(CaseScene& scene, const Mat3& turn, const Vec3& shift) {
  for (Block& block : scene.system.blocks) block.mesh = placed(std::move(block.mesh), turn, shift);
  scene.project.gravity = turn * scene.project.gravity;
  for (InitialVelocity& velocity : scene.project.velocities) {
    velocity.linear = turn * velocity.linear;
    velocity.angular = turn * velocity.angular;
  }
  for (PointLoad& load : scene.project.loads) {
    load.at = turn * load.at + shift;
    load.force = turn * load.force;
    for (TableRow& row : load.table) row.value = turn * row.value;
  }
  for (Constraint& constraint : scene.project.constraints) {
    if (constraint.at) *constraint.at = turn * *constraint.at + shift;
    for (TableRow& row : constraint.table) row.value = turn * row.value;
  }
}

CaseScene moved_elsewhere(CaseScene scene, const Elsewhere& place) {
  place_scene(scene, turn_to(place), place.shift);
  return scene;
}

CaseScene brought_home(CaseScene there, const Elsewhere& place) {
  const Vec3 corner = there.system.blocks.front().mesh.nodes.front();
  place_scene(there, Mat3::Identity(), -corner);  // exact, or nearly: all lies as far out
  place_scene(there, turn_to(place).transpose(), Vec3::Zero());
  return there;
}

double extent_of_what_moves(const CaseScene& scene) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec3 low = Vec3::Constant(far), high = Vec3::Constant(-far);
  for (const Block& block : scene.system.blocks)
    if (block.body != BodyKind::fixed)
      for (const Vec3& node : block.mesh.nodes) {
        low = low.cwiseMin(node);
        high = high.cwiseMax(node);
      }
  return (high - low).norm();
}

double most_apart(const std::vector<Vec3>& at_home, const std::vector<Vec3>& there, const Elsewhere& place) {
  const Mat3 turn = turn_to(place);
  double most = 0;
  for (std::size_t b = 0; b < at_home.size(); ++b) most = std::max(most, (turn * at_home[b] - there[b]).norm());
  return most;
}

}  // namespace talus
