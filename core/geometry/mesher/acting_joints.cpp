#include "geometry/mesher/acting_joints.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace talus {
namespace {

bool acts_on(const MesherCut& cut, int solid) {
  return cut.solids.empty() || std::find(cut.solids.begin(), cut.solids.end(), solid) != cut.solids.end();
}

/// As the cut itself has them, whatever they end at.
std::vector<ActingJoint> whole_joints(const MesherCut& cut, int index, const Vec3& origin) {
  std::vector<ActingJoint> faces;
  for (const MesherJoint& joint : cut.joints) {
    const Vec3 normal = upward_normal(joint.dip, joint.dip_direction), through = joint.through - origin;
    faces.push_back({index, static_cast<int>(faces.size()), {normal, normal.dot(through)}, through, joint.outline});
    for (Vec3& corner : faces.back().outline) corner -= origin;
  }
  if (!faces.empty()) return faces;
  const Vec3 normal = upward_normal(cut.dip, cut.dip_direction), first = cut.through - origin;
  for (int k = 0; k < cut.count; ++k) {
    const double offset = k * cut.spacing;
    faces.push_back({index, k, {normal, normal.dot(first) + offset}, first + offset * normal, {}});
  }
  return faces;
}

/// What of a flat polygon lies on the side where `side` × distance is positive (Sutherland & Hodgman 1974).
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const Plane& plane, double side) {
  std::vector<Vec3> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double from = side * plane.distance(a), to = side * plane.distance(b);
    if (from >= 0) kept.push_back(a);
    if (from * to < 0) kept.push_back(a + from / (from - to) * (b - a));
  }
  return kept;
}

/// Where a polygon crosses a plane, as a length along the line that the two planes share.
struct Stretch {
  double from = 0, to = 0;
};

Stretch stretch_of(const std::vector<Vec3>& polygon, const Plane& plane, const Vec3& line) {
  Stretch stretch{HUGE_VAL, -HUGE_VAL};
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double from = plane.distance(a), to = plane.distance(b);
    if (from * to > 0 || from == to) continue;
    const double along = line.dot(a + from / (from - to) * (b - a));
    stretch = {std::min(stretch.from, along), std::max(stretch.to, along)};
  }
  return stretch;
}

bool meet(const ActingJoint& a, const ActingJoint& b) {
  const Vec3 line = a.plane.normal.cross(b.plane.normal);
  const Stretch first = stretch_of(a.outline, b.plane, line), second = stretch_of(b.outline, a.plane, line);
  return std::max(first.from, second.from) < std::min(first.to, second.to);
}

/// Ends the face at another joint, where it does not run along it.
void end_at(ActingJoint& face, const ActingJoint& other, const MesherJob& job) {
  constexpr double parallel = 1e-3;  // radians; they meet far off, if at all
  if (angle_between(face.plane, other.plane) < parallel) return;
  if (other.ends() && !meet(face, other)) return;
  const double side = other.plane.distance(face.through);
  constexpr double on_it = 1e-9;
  if (std::abs(side) <= on_it * (1 + face.through.norm())) {
    throw InputError(
        job.cuts[static_cast<std::size_t>(face.cut)].title,
        "its point lies on " + job.cuts[static_cast<std::size_t>(other.cut)].title + ", where it is to end",
        "move the point to the side that it is to be on");
  }
  face.outline = clipped(face.outline, other.plane, side > 0 ? 1 : -1);
}

}  // namespace

std::vector<Vec3> square_around(const Plane& plane, const Eigen::AlignedBox3d& bounds) {
  const Vec3 centre = bounds.center(), middle = centre - plane.distance(centre) * plane.normal;
  const Vec3 u = plane.normal.unitOrthogonal() * bounds.diagonal().norm(), v = plane.normal.cross(u);
  return {middle - u - v, middle + u - v, middle + u + v, middle - u + v};
}

std::vector<ActingJoint> acting_joints(const MesherJob& job, int solid, const Vec3& origin,
                                       const Eigen::AlignedBox3d& bounds) {
  std::vector<ActingJoint> whole;
  for (std::size_t c = 0; c < job.cuts.size(); ++c) {
    if (!acts_on(job.cuts[c], solid)) continue;
    const std::vector<ActingJoint> joints = whole_joints(job.cuts[c], static_cast<int>(c), origin);
    whole.insert(whole.end(), joints.begin(), joints.end());
  }
  std::vector<ActingJoint> faces = whole;
  for (ActingJoint& face : faces) {
    const std::vector<int>& ends_at = job.cuts[static_cast<std::size_t>(face.cut)].ends_at;
    if (ends_at.empty()) continue;
    if (!face.ends()) face.outline = square_around(face.plane, bounds);
    for (const ActingJoint& other : whole) {
      const int joint = job.cuts[static_cast<std::size_t>(other.cut)].joint;
      if (other.cut != face.cut && std::find(ends_at.begin(), ends_at.end(), joint) != ends_at.end())
        end_at(face, other, job);
    }
  }
  // What is clipped away wholly is nowhere; what is left of a plane still ends.
  std::erase_if(faces, [&](const ActingJoint& face) {
    const auto& cut = job.cuts[static_cast<std::size_t>(face.cut)];
    return !cut.ends_at.empty() && face.outline.size() < 3;
  });
  std::stable_partition(faces.begin(), faces.end(), [](const ActingJoint& face) { return !face.ends(); });
  return faces;
}

}  // namespace talus
