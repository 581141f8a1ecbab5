#include "session/joint_drawing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "orientation/cut_moves.hpp"
#include "orientation/drawn_planes.hpp"

namespace talus {

namespace {

constexpr int most_sides = 64, least_sides = 8;  // of what is drawn of a disc
constexpr int sides_of_all = 8000;               // of all discs of a network together

template <class Piece>
void append(std::vector<Piece>& to, const std::vector<Piece>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

std::vector<Vec3> cornersOf(const Disc& disc, const Cut& joint, int sides) {
  const Vec3 down = dip_vector_of({joint.dip, joint.dip_direction}), along = normal_of(joint).cross(down);
  std::vector<Vec3> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    corners.push_back(disc.centre + disc.radius * (std::cos(angle) * along + std::sin(angle) * down));
  }
  return corners;
}

/// The polygon's corners on the plane.
std::vector<Vec3> cornersOfPolygon(const Cut& joint) {
  const Vec3 normal = normal_of(joint);
  std::vector<Vec3> corners = joint.polygon;
  for (Vec3& corner : corners) corner -= normal.dot(corner - joint.through) * normal;
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

/// Most discs of a network lie inside the rock: they are drawn whole.
std::vector<PlaneSection> discIn(const SurfaceTree& rock, const Cut& joint, int sides) {
  const Disc& disc = *joint.disc;
  const Vec3 normal = normal_of(joint);
  const std::vector<Vec3> corners = cornersOf(disc, joint, sides);
  if (rock.may_reach(disc.centre, disc.radius))
    return {within({rock, joint.through, normal}, sides_of(corners, normal), std::vector<bool>(corners.size(), true))};
  if (!rock.holds(disc.centre)) return {};
  return {PlaneSection::of_polygon(corners, joint.through, normal)};
}

/// What of a single joint lies in a solid, in pieces.
std::vector<PlaneSection> jointIn(const SurfaceTree& rock, const Cut& joint, int discSides) {
  if (joint.disc) return discIn(rock, joint, discSides);
  const Vec3 normal = normal_of(joint);
  const PlaneSection section(rock, joint.through, normal);
  if (joint.polygon.empty()) return {section};
  const std::vector<Vec3> polygon = cornersOfPolygon(joint);
  std::vector<PlaneSection> pieces;
  for (const FlatTriangle& t : triangles_of(polygon))
    pieces.push_back(within(section, sides_of(t, normal),
                            {isSide(t[0], t[1], polygon), isSide(t[1], t[2], polygon), isSide(t[2], t[0], polygon)}));
  return pieces;
}

/// On the side of each plane of `ends` on which `point` lies.
std::vector<HalfSpace> sidesWith(const Vec3& point, const std::vector<Cut>& ends) {
  std::vector<HalfSpace> sides;
  for (const Cut& end : ends) {
    const Vec3 normal = normal_of(end);
    sides.push_back({end.through, normal.dot(point - end.through) < 0 ? Vec3(-normal) : normal});
  }
  return sides;
}

}  // namespace

JointFace drawn_joint(const Cut& cut, const std::vector<Cut>& ends, const std::vector<JointedRock>& rock) {
  const std::vector<Cut> joints = single_planes(cut);
  std::vector<Cut> planesAtEnds;
  for (const Cut& end : ends) append(planesAtEnds, single_planes(end));
  const int discSides =
      std::clamp(sides_of_all / std::max(1, static_cast<int>(joints.size())), least_sides, most_sides);
  JointFace face;
  for (const Cut& joint : joints) {
    const std::vector<HalfSpace> sides = sidesWith(joint.through, planesAtEnds);
    for (const JointedRock& solid : rock) {
      if (!cut.solids.empty() && std::ranges::count(cut.solids, solid.name) == 0) continue;
      for (PlaneSection& piece : jointIn(*solid.surface, joint, discSides)) {
        for (const HalfSpace& side : sides) piece.clip(side);
        append(face.triangles, piece.triangles());
        append(face.outline, piece.outline());
      }
    }
  }
  return face;
}

}  // namespace talus
