#include "session/drawn_joints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/solid_surface.hpp"
#include "orientation/cut_moves.hpp"
#include "orientation/drawn_planes.hpp"
#include "session/current_project.hpp"
#include "session/solid_surfaces.hpp"

namespace talus {

namespace {

constexpr int disc_sides = 64;

template <class Piece>
void append(std::vector<Piece>& to, const std::vector<Piece>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

std::vector<Vec3> discCorners(const Vec3& centre, double radius, const Cut& plane) {
  const Vec3 down = dip_vector_of({plane.dip, plane.dip_direction}), along = normal_of(plane).cross(down);
  std::vector<Vec3> corners;
  for (int i = 0; i < disc_sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / disc_sides;
    corners.push_back(centre + radius * (std::cos(angle) * along + std::sin(angle) * down));
  }
  return corners;
}

/// The polygon's corners on the plane, with which they moved from that of the cut.
std::vector<Vec3> polygonCorners(const Cut& cut, const Cut& plane) {
  const Vec3 normal = normal_of(plane);
  std::vector<Vec3> corners;
  for (Vec3 corner : cut.polygon) {
    corner += plane.through - cut.through;
    corners.push_back(corner - normal.dot(corner - plane.through) * normal);
  }
  return corners;
}

/// The section within a convex polygon; `sides`: those that end the joint.
PlaneSection within(PlaneSection section, const std::vector<HalfSpace>& all, const std::vector<bool>& sides) {
  for (std::size_t i = 0; i < all.size(); ++i) section.clip(all[i], sides[i]);
  return section;
}

/// The corners follow each other in the polygon.
bool isSide(const Vec3& from, const Vec3& to, const std::vector<Vec3>& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &one = polygon[i], &two = polygon[(i + 1) % polygon.size()];
    if ((one == from && two == to) || (one == to && two == from)) return true;
  }
  return false;
}

/// What of the section a disc or a polygon leaves, in convex pieces.
std::vector<PlaneSection> endedAtItsRim(const Cut& cut, const Cut& plane, const PlaneSection& section) {
  const Vec3 normal = normal_of(plane);
  if (cut.disc) {
    const Vec3 centre = cut.disc->centre + plane.through - cut.through;
    const auto sides = sides_of(discCorners(centre, cut.disc->radius, plane), normal);
    return {within(section, sides, std::vector<bool>(sides.size(), true))};
  }
  if (cut.polygon.empty()) return {section};
  const std::vector<Vec3> polygon = polygonCorners(cut, plane);
  std::vector<PlaneSection> pieces;
  for (const FlatTriangle& t : triangles_of(polygon))
    pieces.push_back(within(section, sides_of(t, normal),
                            {isSide(t[0], t[1], polygon), isSide(t[1], t[2], polygon), isSide(t[2], t[0], polygon)}));
  return pieces;
}

/// On the side of each plane of `ends` on which `point` lies.
std::vector<HalfSpace> sidesWith(const Vec3& point, const std::vector<Cut>& ends) {
  std::vector<HalfSpace> sides;
  for (const Cut& end : ends)
    for (const Cut& plane : single_planes(end)) {
      const Vec3 normal = normal_of(plane);
      sides.push_back({plane.through, normal.dot(point - plane.through) < 0 ? Vec3(-normal) : normal});
    }
  return sides;
}

void draw(JointFace& face, const Cut& cut, const std::vector<Cut>& ends, const std::vector<SolidSurface>& rock) {
  face.triangles.clear();
  face.outline.clear();
  if (cut.network) return;
  for (const Cut& plane : single_planes(cut)) {
    const std::vector<HalfSpace> sides = sidesWith(plane.through, ends);
    for (const SolidSurface& solid : rock) {
      const bool isMeant = cut.solids.empty() || std::ranges::count(cut.solids, solid.name) > 0;
      if (solid.is_part || !isMeant) continue;
      PlaneSection section({solid.vertices, solid.triangles}, plane.through, normal_of(plane));
      for (const HalfSpace& side : sides) section.clip(side);
      for (const PlaneSection& piece : endedAtItsRim(cut, plane, section)) {
        append(face.triangles, piece.triangles());
        append(face.outline, piece.outline());
      }
    }
  }
}

/// Colours go by the order in which sets first appear, as on the stereonet.
std::vector<int> setsOf(const std::vector<Cut>& cuts) {
  std::vector<std::string> names;
  std::vector<int> sets;
  for (const Cut& cut : cuts) {
    const auto found = std::ranges::find(names, cut.joint);
    sets.push_back(static_cast<int>(found - names.begin()));
    if (found == names.end()) names.push_back(cut.joint);
  }
  return sets;
}

}  // namespace

DrawnJoints::DrawnJoints(CurrentProject& project, SolidSurfaces& surfaces) : project_(project), surfaces_(surfaces) {
  connect(&project_, &CurrentProject::opened, this, &DrawnJoints::follow);
  connect(&project_.document(), &Document::projectChanged, this, &DrawnJoints::follow);
  connect(&surfaces_, &SolidSurfaces::changed, this, [this] {
    faces_.clear();
    emit changed();
  });
}

DrawnJoints::~DrawnJoints() = default;

void DrawnJoints::follow() {
  trial_.reset();
  emit changed();
}

std::vector<Cut> DrawnJoints::cuts() const {
  std::vector<Cut> cuts = project_.document().project().cuts;
  if (trial_ && trial_->cut < static_cast<int>(cuts.size())) cuts[static_cast<std::size_t>(trial_->cut)] = trial_->as;
  return cuts;
}

std::vector<int> DrawnJoints::selectedCuts() {
  const Project& project = project_.document().project();
  const Item& current = project_.selection().current();
  if (current.kind == Item::Kind::cut) return {current.index};
  std::vector<int> chosen;
  const bool isJoint = current.kind == Item::Kind::joint && current.index >= 0 &&
                       current.index < static_cast<int>(project.joints.size());
  for (std::size_t i = 0; isJoint && i < project.cuts.size(); ++i)
    if (project.cuts[i].joint == project.joints[static_cast<std::size_t>(current.index)].name)
      chosen.push_back(static_cast<int>(i));
  return chosen;
}

void DrawnJoints::tryOut(int cut, const Cut& as) {
  trial_ = Trial{cut, as};
  emit changed();
}

void DrawnJoints::endTrial() {
  if (!trial_) return;
  trial_.reset();
  emit changed();
}

const std::vector<JointFace>& DrawnJoints::faces() {
  static const std::vector<SolidSurface> nowhere;
  const auto* rock = surfaces_.current();
  const std::vector<Cut> cuts = this->cuts();
  const std::vector<int> sets = setsOf(cuts);
  made_.resize(cuts.size());
  faces_.resize(cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    std::vector<Cut> ends;
    for (const Cut& other : cuts)
      if (std::ranges::count(cuts[i].ends_at, other.joint) > 0) ends.push_back(other);
    if (faces_[i].cut < 0 || made_[i].cut != cuts[i] || made_[i].ends != ends)
      draw(faces_[i], cuts[i], ends, rock ? *rock : nowhere);
    faces_[i].cut = static_cast<int>(i);
    faces_[i].set = sets[i];
    made_[i] = {cuts[i], std::move(ends)};
  }
  return faces_;
}

std::optional<Vec3> DrawnJoints::middleOf(int cut) {
  double area = 0;
  Vec3 moment = Vec3::Zero();
  for (const FlatTriangle& triangle : faces().at(static_cast<std::size_t>(cut)).triangles) {
    const double one = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm();
    area += one;
    moment += one * (triangle[0] + triangle[1] + triangle[2]) / 3;
  }
  return area > 0 ? std::optional<Vec3>(moment / area) : std::nullopt;
}

}  // namespace talus
