#include "render/scene/thinned_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>

namespace talus {
namespace {

constexpr double farthest = 1.0 / 200;   // of the size: from the planes of all triangles that were around a point
constexpr double finest = 1e-6;          // of the size: flat faces lose their points first
constexpr double coarsening = 2;         // from one round to the next
constexpr std::size_t most_around = 24;  // triangles around a point: fans of needles are ugly
constexpr double least_turn = 0.2;       // cosine between a triangle and what becomes of it

/// A quadratic form: the sum of the squares of a point's distances from planes.
using Planes = Eigen::Matrix4d;

double squares(const Planes& planes, const Vec3& point) {
  const Eigen::Vector4d p = point.homogeneous();
  return p.dot(planes * p);
}

class Thinning {
 public:
  explicit Thinning(const RockSurface& rock)
      : points_(rock.points), triangles_(rock.triangles.begin(), rock.triangles.end()), left_(triangles_.size()) {
    around_.resize(points_.size());
    planes_.resize(points_.size(), Planes::Zero());
    Eigen::AlignedBox3d box;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const int point : triangles_[t]) {
        around_[static_cast<std::size_t>(point)].push_back(static_cast<int>(t));
        box.extend(at(point));
      }
    origin_ = box.center();
    size_ = box.diagonal().norm();
    for (const auto& triangle : triangles_) add_plane(triangle);
  }

  std::vector<std::array<int, 3>> down_to(std::size_t most) {
    for (double distance = finest * size_; left_ > most && distance < farthest * size_; distance *= coarsening)
      for (std::size_t point = 0; point < points_.size() && left_ > most; ++point)
        leave_out(static_cast<int>(point), distance * distance);
    std::erase_if(triangles_, [](const auto& triangle) { return triangle[0] < 0; });
    return std::move(triangles_);
  }

 private:
  const Vec3& at(int point) const { return points_[static_cast<std::size_t>(point)]; }
  static bool has(const std::array<int, 3>& triangle, int point) { return std::ranges::count(triangle, point) > 0; }
  const std::array<int, 3>& triangle(int t) const { return triangles_[static_cast<std::size_t>(t)]; }
  std::vector<int>& around(int point) { return around_[static_cast<std::size_t>(point)]; }
  Vec3 area(const std::array<int, 3>& t) const { return (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])) / 2; }

  void add_plane(const std::array<int, 3>& triangle) {
    const Vec3 normal = area(triangle).normalized();
    Eigen::Vector4d plane;
    plane << normal, -normal.dot(at(triangle[0]) - origin_);
    for (const int point : triangle) planes_[static_cast<std::size_t>(point)] += plane * plane.transpose();
  }

  /// Those that share an edge with it; ascending.
  std::vector<int> neighbours(int point) {
    std::vector<int> found;
    for (const int t : around(point))
      for (const int other : triangle(t))
        if (other != point) found.push_back(other);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Draws the point to the neighbour where that costs least, if to any.
  void leave_out(int point, double most_square) {
    if (around(point).empty()) return;
    const std::vector<int> all = neighbours(point);
    if (all.size() != around(point).size()) return;  // a border, or more than one sheet
    std::optional<int> best;
    double least = most_square;
    for (const int to : all) {
      const double cost = squares(planes_[static_cast<std::size_t>(point)], at(to) - origin_);
      if (cost >= least || !may_move(point, to, all)) continue;
      least = cost;
      best = to;
    }
    if (best) move(point, *best);
  }

  bool may_move(int point, int to, const std::vector<int>& all) {
    std::vector<int> common;
    std::ranges::set_intersection(all, neighbours(to), std::back_inserter(common));
    if (common.size() != 2 || around(point).size() + around(to).size() > most_around + 4) return false;
    return std::ranges::all_of(around(point), [&](int t) {
      if (has(triangle(t), to)) return true;
      std::array<int, 3> moved = triangle(t);
      std::ranges::replace(moved, point, to);
      const Vec3 before = area(triangle(t)), after = area(moved);
      return before.dot(after) > least_turn * before.norm() * after.norm();
    });
  }

  void move(int point, int to) {
    for (const int t : around(point)) {
      auto& corners = triangles_[static_cast<std::size_t>(t)];
      if (has(corners, to)) {
        for (const int corner : corners)
          if (corner != point) std::erase(around(corner), t);
        corners = {-1, -1, -1};
        --left_;
      } else {
        std::ranges::replace(corners, point, to);
        around(to).push_back(t);
      }
    }
    around(point).clear();
    planes_[static_cast<std::size_t>(to)] += planes_[static_cast<std::size_t>(point)];
  }

  std::span<const Vec3> points_;
  std::vector<std::array<int, 3>> triangles_;  ///< −1: left out
  std::size_t left_;
  std::vector<std::vector<int>> around_;  ///< a point: its triangles
  std::vector<Planes> planes_;            ///< a point: those around it and around all that were drawn to it
  Vec3 origin_ = Vec3::Zero();
  double size_ = 0;
};

}  // namespace

std::vector<std::array<int, 3>> thinned(const RockSurface& rock, std::size_t most) {
  if (rock.triangles.size() <= most) return {rock.triangles.begin(), rock.triangles.end()};
  return Thinning(rock).down_to(most);
}

}  // namespace talus
