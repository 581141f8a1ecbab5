#include "geometry/mesher/cells/cell_complex.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "geometry/mesher/cells/face_border.hpp"

namespace talus {
namespace {

/// Which side of a plane every vertex lies on, and the points in which the plane crosses edges, each once.
class Division {
 public:
  Division(std::vector<Vec3>& vertices, const Plane& plane, double reach) : vertices_(vertices) {
    for (const Vec3& vertex : vertices) {
      distances_.push_back(plane.distance(vertex));
      sides_.push_back(distances_.back() > reach ? 1 : distances_.back() < -reach ? -1 : 0);
    }
  }

  /// −1 below, 0 on the plane, 1 above.
  int side(int vertex) const { return sides_[static_cast<std::size_t>(vertex)]; }

  int crossing(int from, int to) {
    if (from > to) std::swap(from, to);
    const auto key = static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint32_t>(to);
    const auto [known, fresh] = crossings_.try_emplace(key, static_cast<int>(vertices_.size()));
    if (fresh) {
      const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
      const double share = distances_[a] / (distances_[a] - distances_[b]);
      const Vec3 point = vertices_[a] + share * (vertices_[b] - vertices_[a]);
      vertices_.push_back(point);
      distances_.push_back(0);
      sides_.push_back(0);
    }
    return known->second;
  }

 private:
  std::vector<Vec3>& vertices_;
  std::vector<double> distances_;
  std::vector<signed char> sides_;
  std::unordered_map<std::uint64_t, int> crossings_;
};

struct Extent {
  bool below = false, above = false;
};

Extent extent_of(const CellFace& face, const Division& division) {
  Extent extent;
  for (int corner : face.corners) {
    extent.below |= division.side(corner) < 0;
    extent.above |= division.side(corner) > 0;
  }
  return extent;
}

Extent extent_of(const Cell& cell, const Division& division) {
  Extent extent;
  for (const CellFace& face : cell) {
    const Extent part = extent_of(face, division);
    extent.below |= part.below;
    extent.above |= part.above;
  }
  return extent;
}

/// The face below and above the plane; either may have fewer than three corners.
std::pair<CellFace, CellFace> divided(const CellFace& face, Division& division) {
  CellFace below{{}, face.mark}, above{{}, face.mark};
  for (std::size_t k = 0; k < face.corners.size(); ++k) {
    const int from = face.corners[k], to = face.corners[(k + 1) % face.corners.size()];
    if (division.side(from) <= 0) below.corners.push_back(from);
    if (division.side(from) >= 0) above.corners.push_back(from);
    if (division.side(from) * division.side(to) < 0) {
      const int crossing = division.crossing(from, to);
      below.corners.push_back(crossing);
      above.corners.push_back(crossing);
    }
  }
  return {below, above};
}

/// The face that closes a cell which is open along one loop.
CellFace lid(const Cell& cell, int mark) {
  std::vector<DirectedEdge> edges, open;
  for (const CellFace& face : cell) add_edges(face, edges);
  for (const auto& [from, to] : border_of(std::move(edges)))
    open.emplace_back(to, from);  // the lid is seen from outside
  CellFace face{{}, mark};
  if (open.empty()) return face;
  int corner = open.front().first;
  do {
    face.corners.push_back(corner);
    const auto next =
        std::find_if(open.begin(), open.end(), [&](const DirectedEdge& edge) { return edge.first == corner; });
    corner = next == open.end() ? open.front().first : next->second;
  } while (corner != open.front().first && face.corners.size() <= open.size());
  return face;
}

/// The parts of a cell on both sides of the plane.
std::pair<Cell, Cell> divided(const Cell& cell, Division& division, int mark) {
  Cell lower, upper;
  for (const CellFace& face : cell) {
    const Extent extent = extent_of(face, division);
    auto [below, above] = divided(face, division);
    if (extent.below && below.corners.size() > 2) lower.push_back(std::move(below));
    if (extent.above && above.corners.size() > 2) upper.push_back(std::move(above));
  }
  CellFace top = lid(lower, mark), bottom{{top.corners.rbegin(), top.corners.rend()}, mark};
  lower.push_back(std::move(top));
  upper.push_back(std::move(bottom));
  return {std::move(lower), std::move(upper)};
}

Eigen::AlignedBox3d box_around(const Cell& cell, const std::vector<Vec3>& vertices) {
  Eigen::AlignedBox3d box;
  for (const CellFace& face : cell)
    for (int corner : face.corners) box.extend(vertices[static_cast<std::size_t>(corner)]);
  return box;
}

bool may_meet(const Eigen::AlignedBox3d& box, const Plane& plane, double reach) {
  constexpr double rounding = 2;  // of the reach
  const double extent = plane.normal.cwiseAbs().dot(box.sizes()) / 2;
  return std::abs(plane.distance(box.center())) <= extent + rounding * reach;
}

}  // namespace

CellComplex::CellComplex(std::vector<Vec3> vertices, std::vector<Cell> cells, double reach)
    : vertices_(std::move(vertices)), cells_(std::move(cells)), reach_(reach) {
  for (const Cell& cell : cells_) boxes_.push_back(box_around(cell, vertices_));
}

bool CellComplex::cut(const Plane& plane, int mark, int first_joint) {
  Division division(vertices_, plane, reach_);
  bool met = false;
  const std::size_t count = cells_.size();
  for (std::size_t c = 0; c < count; ++c) {
    if (!may_meet(boxes_[c], plane, reach_)) continue;
    const Extent extent = extent_of(cells_[c], division);
    if (extent.below && extent.above) {
      auto [lower, upper] = divided(cells_[c], division, mark);
      cells_[c] = std::move(lower);
      cells_.push_back(std::move(upper));
      boxes_[c] = box_around(cells_[c], vertices_);
      boxes_.push_back(box_around(cells_.back(), vertices_));
      met = true;
      continue;
    }
    for (CellFace& face : cells_[c]) {
      const Extent part = extent_of(face, division);
      if (part.below || part.above || face.mark >= first_joint) continue;
      face.mark = mark;
      met = true;
    }
  }
  return met;
}

double volume_of(const Cell& cell, const std::vector<Vec3>& vertices) {
  const auto at = [&](int v) -> const Vec3& { return vertices[static_cast<std::size_t>(v)]; };
  const Vec3& origin = at(cell.front().corners.front());
  double sixfold = 0;
  for (const CellFace& face : cell)
    for (std::size_t k = 1; k + 1 < face.corners.size(); ++k)
      sixfold +=
          (at(face.corners[0]) - origin).dot((at(face.corners[k]) - origin).cross(at(face.corners[k + 1]) - origin));
  return sixfold / 6;
}

bool holds(const Cell& cell, const std::vector<Vec3>& vertices, const Vec3& point) {
  return std::all_of(cell.begin(), cell.end(), [&](const CellFace& face) {
    const Vec3& corner = vertices[static_cast<std::size_t>(face.corners.front())];
    return area_of(face, vertices).dot(point - corner) <= 0;
  });
}

Vec3 area_of(const CellFace& face, const std::vector<Vec3>& vertices) {
  const auto at = [&](std::size_t k) -> const Vec3& { return vertices[static_cast<std::size_t>(face.corners[k])]; };
  Vec3 twice = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < face.corners.size(); ++k) twice += (at(k) - at(0)).cross(at(k + 1) - at(0));
  return twice / 2;
}

}  // namespace talus
