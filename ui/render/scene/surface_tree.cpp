#include "render/scene/surface_tree.hpp"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr int leaf_size = 8;  // triangles

/// Whether the ray meets the box; `over_direction`: one over each component.
bool meets(const Eigen::AlignedBox3d& box, const Vec3& from, const Vec3& over_direction) {
  const Eigen::Array3d a = (box.min() - from).array() * over_direction.array(),
                       b = (box.max() - from).array() * over_direction.array();
  return std::max(0.0, a.min(b).maxCoeff()) <= a.max(b).minCoeff();
}

}  // namespace

SurfaceTree::SurfaceTree(const RockSurface& rock)
    : points_(rock.points.begin(), rock.points.end()), triangles_(rock.triangles.begin(), rock.triangles.end()) {
  if (!triangles_.empty()) build(0, static_cast<int>(triangles_.size()));
}

/// Divides in the middle of the box around them along its longest side, or where all lie on one side by their number.
int SurfaceTree::build(int begin, int end) {
  const auto three_middles = [&](const std::array<int, 3>& t, Eigen::Index axis) {
    return points_[t[0]][axis] + points_[t[1]][axis] + points_[t[2]][axis];
  };
  const auto index = nodes_.size();
  Eigen::AlignedBox3d box;
  for (int t = begin; t < end; ++t)
    for (const int point : triangles_[t]) box.extend(points_[point]);
  nodes_.push_back({box, begin, end, 0});
  if (end - begin > leaf_size) {
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto first = triangles_.begin() + begin, last = triangles_.begin() + end;
    const double halfway = 3 * box.center()[axis];
    auto divide = std::partition(first, last, [&](const auto& t) { return three_middles(t, axis) < halfway; });
    if (divide == first || divide == last) divide = first + (end - begin) / 2;
    const int middle = static_cast<int>(divide - triangles_.begin());
    build(begin, middle);
    nodes_[index].right = build(middle, end);
  }
  return static_cast<int>(index);
}

template <class Wanted, class Take>
void SurfaceTree::visit(const Wanted& wanted, const Take& take) const {
  std::vector<int> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const int index = open.back();
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    open.pop_back();
    if (!wanted(node.box)) continue;
    if (node.right > 0)
      open.insert(open.end(), {node.right, index + 1});
    else
      for (int t = node.begin; t < node.end; ++t) take(t);
  }
}

std::vector<int> SurfaceTree::near_plane(const Vec3& point, const Vec3& normal) const {
  constexpr double rounding = 1e-12;
  const Vec3 size = normal.cwiseAbs();
  std::vector<int> found;
  visit(
      [&](const Eigen::AlignedBox3d& box) {
        const Vec3 from = box.center() - point;
        const double reach = size.dot(box.sizes()) / 2;
        return std::abs(normal.dot(from)) <= reach + rounding * size.dot(from.cwiseAbs());
      },
      [&](int triangle) { found.push_back(triangle); });
  return found;
}

bool SurfaceTree::may_reach(const Vec3& centre, double radius) const {
  bool reaches = false;
  visit(
      [&](const Eigen::AlignedBox3d& box) {
        return !reaches && box.squaredExteriorDistance(centre) <= radius * radius;
      },
      [&](int) { reaches = true; });
  return reaches;
}

bool SurfaceTree::holds(const Vec3& point) const {
  // A way along which the edges of no grid lie; Möller and Trumbore (1997).
  const Vec3 along = Vec3(0.3129, 0.2371, 0.9196).normalized(), over = along.cwiseInverse();
  bool inside = false;
  visit([&](const Eigen::AlignedBox3d& box) { return meets(box, point, over); },
        [&](int triangle) {
          const auto& [i, j, k] = triangles_[static_cast<std::size_t>(triangle)];
          const Vec3 ab = points_[j] - points_[i], ac = points_[k] - points_[i], p = along.cross(ac);
          const double determinant = ab.dot(p);
          if (determinant == 0) return;
          const Vec3 from_a = point - points_[i], q = from_a.cross(ab);
          const double u = from_a.dot(p) / determinant, v = along.dot(q) / determinant;
          inside ^= u >= 0 && v >= 0 && u + v <= 1 && ac.dot(q) / determinant > 0;
        });
  return inside;
}

}  // namespace talus
