#include "solve/local_origin.hpp"

#include <cmath>

#include "contact/broad/box.hpp"

namespace talus {

namespace {

/// Extents. Nearer models keep the origin that they have.
constexpr double near = 8;

void move(std::vector<PointLoad>& loads, const Vec3& origin) {
  for (PointLoad& load : loads) load.at -= origin;
}

void move(std::vector<Constraint>& constraints, const Vec3& origin) {
  for (Constraint& constraint : constraints)
    if (constraint.at) *constraint.at -= origin;
}

/// What a solver reads of a project; solids and cuts stay where they are.
void move(Project& project, const Vec3& origin) {
  move(project.loads, origin);
  move(project.constraints, origin);
  for (Stage& stage : project.stages) {
    if (stage.loads) move(*stage.loads, origin);
    if (stage.constraints) move(*stage.constraints, origin);
  }
  for (Monitor& monitor : project.monitors) monitor.at -= origin;
  for (InSituStress& stress : project.in_situ) stress.level -= origin.z();
}

}  // namespace

Vec3 local_origin(const BlockSystem& system) {
  Box box;
  for (const Block& block : system.blocks)
    for (const Vec3& node : block.mesh.nodes) box.add(node);
  const Vec3 centre = (box.lower + box.upper) / 2;
  const double extent = (box.upper - box.lower).norm();
  if (!(centre.cwiseAbs().maxCoeff() > near * extent)) return Vec3::Zero();
  const double unit = std::exp2(std::floor(std::log2(extent)));
  return unit * (centre / unit).array().round();
}

LocalModel::LocalModel(const Project& project, const BlockSystem& system)
    : project_(project), system_(system), origin_(local_origin(system)) {
  if (origin_.isZero(0)) return;
  moved_.emplace(Moved{project, system});
  move(moved_->project, origin_);
  for (Block& block : moved_->system.blocks)
    for (Vec3& node : block.mesh.nodes) node -= origin_;
}

}  // namespace talus
