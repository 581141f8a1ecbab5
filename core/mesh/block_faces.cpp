#include "mesh/block_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace talus {

namespace {

using Vec2 = Eigen::Vector2d;

double model_size(const BlockSystem& system) {
  Eigen::AlignedBox3d box;
  for (const Block& block : system.blocks)
    for (const Vec3& node : block.mesh.nodes) box.extend(node);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

void add_faces(const Block& block, int index, double tolerance, std::vector<FlatFace>& faces) {
  const std::size_t first = faces.size();
  for (std::size_t t = 0; t < block.surface.size(); ++t) {
    const auto& [a, b, c] = block.surface[t].nodes;
    const Vec3& p = block.mesh.nodes[a];
    const Vec3 twice = (block.mesh.nodes[b] - p).cross(block.mesh.nodes[c] - p);
    const double area = twice.norm() / 2;
    if (!(area > 0)) continue;
    const Vec3 normal = twice / (2 * area);
    const auto face = std::find_if(faces.begin() + static_cast<std::ptrdiff_t>(first), faces.end(), [&](const auto& f) {
      return f.joint == block.surface[t].joint && (f.normal - normal).squaredNorm() < same_normal * same_normal &&
             std::abs(f.normal.dot(p) - f.offset) < tolerance;
    });
    if (face == faces.end()) {
      faces.push_back({index, block.surface[t].joint, normal, normal.dot(p), area, {static_cast<int>(t)}});
    } else {
      face->area += area;
      face->triangles.push_back(static_cast<int>(t));
    }
  }
}

/// Area that two triangles of one plane have in common, both counter-clockwise: one is cut off by the other's sides.
double common_area(const std::array<Vec2, 3>& one, const std::array<Vec2, 3>& other) {
  const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
  std::array<Vec2, 6> polygon{one[0], one[1], one[2]}, next;
  std::size_t size = 3;
  for (std::size_t side = 0; side < 3 && size > 0; ++side) {
    const Vec2& from = other[side];
    const Vec2 along = other[(side + 1) % 3] - from;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const Vec2 &p = polygon[i], &q = polygon[(i + 1) % size];
      const double inside_p = cross(along, p - from), inside_q = cross(along, q - from);
      if (inside_p >= 0) next[kept++] = p;
      if (inside_p * inside_q < 0) next[kept++] = p + (q - p) * (inside_p / (inside_p - inside_q));
    }
    std::swap(polygon, next);
    size = kept;
  }
  double twice = 0;
  for (std::size_t i = 1; i + 1 < size; ++i) twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return twice / 2;
}

/// The triangles of faces in coordinates of one plane, counter-clockwise seen along `up`.
class PlaneView {
 public:
  PlaneView(const BlockSystem& system, const Vec3& up) : system_(system), x_(up.unitOrthogonal()), y_(up.cross(x_)) {}

  std::vector<std::array<Vec2, 3>> triangles(const FlatFace& face, bool seen_from_behind) const {
    const Block& block = system_.blocks[face.block];
    std::vector<std::array<Vec2, 3>> flat;
    for (const int t : face.triangles) {
      auto [a, b, c] = block.surface[t].nodes;
      if (seen_from_behind) std::swap(b, c);
      flat.push_back({at(block.mesh.nodes[a]), at(block.mesh.nodes[b]), at(block.mesh.nodes[c])});
    }
    return flat;
  }

 private:
  Vec2 at(const Vec3& point) const { return {x_.dot(point), y_.dot(point)}; }
  const BlockSystem& system_;
  Vec3 x_, y_;
};

Eigen::AlignedBox2d box_of(const std::array<Vec2, 3>& triangle) {
  Eigen::AlignedBox2d box;
  for (const Vec2& corner : triangle) box.extend(corner);
  return box;
}

double shared_area(const BlockSystem& system, const FlatFace& one, const FlatFace& other) {
  const PlaneView view(system, one.normal);
  const auto front = view.triangles(one, false), back = view.triangles(other, true);
  std::vector<Eigen::AlignedBox2d> back_boxes;
  for (const auto& triangle : back) back_boxes.push_back(box_of(triangle));
  double area = 0;
  for (const auto& a : front) {
    const Eigen::AlignedBox2d box = box_of(a);
    for (std::size_t i = 0; i < back.size(); ++i)
      if (box.intersects(back_boxes[i])) area += common_area(a, back[i]);
  }
  return area;
}

/// Pairs of faces whose boxes touch, by a sweep along x.
template <class Visit>
void for_touching_boxes(const std::vector<Eigen::AlignedBox3d>& boxes, const Visit& visit) {
  std::vector<int> order(boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return boxes[a].min().x() < boxes[b].min().x(); });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].min().x() <= boxes[order[i]].max().x(); ++j)
      if (boxes[order[i]].intersects(boxes[order[j]]))
        visit(std::min(order[i], order[j]), std::max(order[i], order[j]));
}

Eigen::AlignedBox3d box_of(const BlockSystem& system, const FlatFace& face, double margin) {
  const Block& block = system.blocks[face.block];
  Eigen::AlignedBox3d box;
  for (const int t : face.triangles)
    for (const int node : block.surface[t].nodes) box.extend(block.mesh.nodes[node]);
  return {box.min() - Vec3::Constant(margin), box.max() + Vec3::Constant(margin)};
}

}  // namespace

BlockFaces block_faces(const BlockSystem& system) {
  const double tolerance = same_plane * model_size(system);
  BlockFaces result;
  for (std::size_t i = 0; i < system.blocks.size(); ++i)
    add_faces(system.blocks[i], static_cast<int>(i), tolerance, result.faces);

  std::vector<Eigen::AlignedBox3d> boxes;
  for (const FlatFace& face : result.faces) boxes.push_back(box_of(system, face, tolerance));
  for_touching_boxes(boxes, [&](int a, int b) {
    const FlatFace &one = result.faces[a], &other = result.faces[b];
    if (one.block == other.block || (one.normal + other.normal).squaredNorm() > same_normal * same_normal ||
        std::abs(one.offset + other.offset) > 2 * tolerance)
      return;
    const double area = shared_area(system, one, other);
    if (area > same_plane * std::min(one.area, other.area)) result.shared.push_back({a, b, area});
  });
  std::sort(result.shared.begin(), result.shared.end(), [](const SharedFace& a, const SharedFace& b) {
    return std::pair(a.face, a.other) < std::pair(b.face, b.other);
  });
  return result;
}

}  // namespace talus
