#include "geometry/mesher/cells/flat_facet.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "mesh/size_field.hpp"

namespace talus {
namespace {

/// Points by the square that they lie in, to be asked who is near.
class Squares {
 public:
  explicit Squares(double side) : side_(side) {}

  void add(const Eigen::Vector2d& point) { squares_[key(cell(point.x()), cell(point.y()))].push_back(point); }

  bool any_within(const Eigen::Vector2d& point, double distance) const {
    const auto reach = static_cast<std::int64_t>(std::ceil(distance / side_));
    for (std::int64_t i = -reach; i <= reach; ++i)
      for (std::int64_t k = -reach; k <= reach; ++k) {
        const auto square = squares_.find(key(cell(point.x()) + i, cell(point.y()) + k));
        if (square == squares_.end()) continue;
        for (const Eigen::Vector2d& other : square->second)
          if ((other - point).norm() < distance) return true;
      }
    return false;
  }

 private:
  std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x / side_)); }
  static std::int64_t key(std::int64_t i, std::int64_t k) { return i * 0x100000000 + k; }

  double side_;
  std::unordered_map<std::int64_t, std::vector<Eigen::Vector2d>> squares_;
};

double smallest_size(const SkinSize& size) {
  double smallest = size.own;
  for (const MeshRefinement& refinement : size.refinements) smallest = std::min(smallest, refinement.size);
  return smallest;
}

}  // namespace

FlatFacet::FlatFacet(const FacetOutline& outline, const SkinVertices& vertices) {
  const Vec3 normal = outline.normal.normalized();
  origin_ = vertices[outline.edges.begin()->first];
  u_ = normal.unitOrthogonal();
  v_ = normal.cross(u_);
  for (const auto& [from, to] : outline.edges) {
    const Vec3 arm = vertices[from] - origin_;
    points_[from] = {arm.dot(u_), arm.dot(v_)};
    outgoing_.emplace(from, to);
    incoming_.emplace(to, from);
  }
  const Points flat = points_;
  for (const auto& [from, to] : outline.edges)
    if (!is_straight(from, flat) && is_straight(to, flat)) draw_in(from, to, flat);
}

bool FlatFacet::is_straight(int vertex, const Points& flat) const {
  if (outgoing_.count(vertex) != 1 || incoming_.count(vertex) != 1) return false;
  constexpr double straight = 1e-7;
  const Eigen::Vector2d a = flat.at(vertex) - flat.at(incoming_.find(vertex)->second);
  const Eigen::Vector2d b = flat.at(outgoing_.find(vertex)->second) - flat.at(vertex);
  return a.dot(b) > 0 && std::abs(a.x() * b.y() - a.y() * b.x()) < straight * a.norm() * b.norm();
}

void FlatFacet::draw_in(int start, int first, const Points& flat) {
  std::vector<int> stretch;
  int vertex = first;
  for (; is_straight(vertex, flat); vertex = outgoing_.find(vertex)->second) stretch.push_back(vertex);
  const Eigen::Vector2d chord = flat.at(vertex) - flat.at(start);
  const Eigen::Vector2d inwards(-chord.y(), chord.x());
  constexpr double bow = 1e-5;
  for (int between : stretch) {
    const double share = (flat.at(between) - flat.at(start)).norm() / chord.norm();
    points_[between] += bow * share * (1 - share) * inwards;
  }
}

std::vector<Eigen::Vector2d> FlatFacet::lattice(const SkinSize& size) const {
  const double step = smallest_size(size), row = std::sqrt(0.75) * step;
  Eigen::AlignedBox2d box;
  Squares taken(size.own);
  for (const auto& [vertex, point] : points_) {
    box.extend(point);
    taken.add(point);
  }
  std::vector<Eigen::Vector2d> points;
  constexpr double apart = 0.7;  // of the size: where it changes, a row must not fall out
  for (int j = 0; box.min().y() + j * row < box.max().y(); ++j) {
    for (int i = 0; box.min().x() + i * step < box.max().x(); ++i) {
      const Eigen::Vector2d point(box.min().x() + (i + (j % 2) * 0.5) * step, box.min().y() + j * row);
      if (taken.any_within(point, apart * size_at(in_space(point), size.own, size.refinements))) continue;
      taken.add(point);
      points.push_back(point);
    }
  }
  return points;
}

}  // namespace talus
