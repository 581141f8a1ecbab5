#include "geometry/corner_solids.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/block_description.hpp"
#include "model/polyhedron.hpp"
#include "model/solid_shape.hpp"
#include "orientation/drawn_planes.hpp"
#include "orientation/joint_outline.hpp"

namespace talus {
namespace {

using Box = Eigen::AlignedBox3d;

/// But for coordinates of five digits.
bool is_convex(const PolyhedronShape& shape, const Box& box) {
  constexpr double rounding = 1e-5;
  const double reach = rounding * box.sizes().maxCoeff();
  return std::ranges::all_of(shape.faces, [&](const std::vector<int>& face) {
    const Vec3 normal = doubled_area(shape, face).normalized();
    const double front = normal.dot(shape.vertices[static_cast<std::size_t>(face.front())]) + reach;
    return std::ranges::all_of(shape.vertices, [&](const Vec3& vertex) { return normal.dot(vertex) <= front; });
  });
}

/// Whether no block of the solid in the box is filled with tetrahedra of some size.
bool corners_suffice_in(const Box& box, const Project& project, const Solid& solid) {
  return corners_suffice(solid.body, solid, nullptr, true) &&
         std::ranges::all_of(project.blocks, [&](const BlockOverride& wanted) {
           return !box.contains(wanted.at) || corners_suffice(wanted.body.value_or(solid.body), solid, &wanted, true);
         });
}

bool is_part(const Project& project, const Solid& solid) {
  return std::ranges::any_of(project.solids, [&](const Solid& whole) {
    const auto* combined = std::get_if<CombinedShape>(&whole.shape);
    return combined && std::ranges::find(combined->solids, solid.name) != combined->solids.end();
  });
}

/// The cuts of which joints end.
std::vector<const Cut*> ending_cuts(const Project& project) {
  std::vector<const Cut*> ending;
  for (const Cut& cut : project.cuts) {
    const std::vector<Cut> joints = single_planes(cut);
    const auto ends = [](const Cut& joint) { return !outline_of(joint).empty(); };
    if (!cut.ends_at.empty() || std::ranges::any_of(joints, ends)) ending.push_back(&cut);
  }
  return ending;
}

bool acts_on(const Cut& cut, const Solid& solid) {
  return cut.solids.empty() || std::ranges::find(cut.solids, solid.name) != cut.solids.end();
}

}  // namespace

std::vector<bool> corner_solids(const Project& project) {
  const std::vector<const Cut*> ending = ending_cuts(project);
  std::vector<bool> of_corners;
  for (const Solid& solid : project.solids) {
    Box box;
    const auto shape = polyhedron_of(solid);
    if (shape)
      for (const Vec3& vertex : shape->vertices) box.extend(vertex);
    of_corners.push_back(shape && corners_suffice_in(box, project, solid) && !is_part(project, solid) &&
                         std::ranges::none_of(ending, [&](const Cut* cut) { return acts_on(*cut, solid); }) &&
                         is_convex(*shape, box));
  }
  return of_corners;
}

}  // namespace talus
