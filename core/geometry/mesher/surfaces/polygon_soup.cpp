#include "geometry/mesher/surfaces/polygon_soup.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>

#include "mesh/polygon_triangles.hpp"

namespace talus {
namespace {

/// Points that are found again by their place.
class PointGrid {
 public:
  explicit PointGrid(double reach) : reach_(reach) {}

  /// The number of a point within reach that is there already, or of this one, which is then new.
  int number_of(const Vec3& point) {
    const Cell home = cell_of(point);
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z) {
          const auto near = cells_.find({home[0] + x, home[1] + y, home[2] + z});
          if (near == cells_.end()) continue;
          for (const int i : near->second)
            if ((points_[static_cast<std::size_t>(i)] - point).norm() <= reach_) return i;
        }
    const int number = static_cast<int>(points_.size());
    points_.push_back(point);
    cells_[home].push_back(number);
    return number;
  }

  const std::vector<Vec3>& points() const { return points_; }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& cell) const {
      std::uint64_t hash = 1469598103934665603u;  // FNV-1a
      for (const std::int64_t part : cell) hash = (hash ^ static_cast<std::uint64_t>(part)) * 1099511628211u;
      return hash;
    }
  };

  Cell cell_of(const Vec3& point) const {
    return {static_cast<std::int64_t>(std::floor(point.x() / reach_)),
            static_cast<std::int64_t>(std::floor(point.y() / reach_)),
            static_cast<std::int64_t>(std::floor(point.z() / reach_))};
  }

  double reach_;
  std::vector<Vec3> points_;
  std::unordered_map<Cell, std::vector<int>, Hash> cells_;
};

std::vector<std::array<int, 3>> triangles_of(const PolygonSoup& soup, const std::vector<int>& polygon) {
  if (polygon.size() == 3) return {{polygon[0], polygon[1], polygon[2]}};
  return polygon_triangles(soup.points, polygon);
}

}  // namespace

TriangleSoup welded(const PolygonSoup& soup) {
  constexpr double near = 1e-6;
  Eigen::AlignedBox3d bounds;
  for (const Vec3& point : soup.points) bounds.extend(point);
  PointGrid grid(std::max(near * bounds.diagonal().norm(), 1e-12));
  TriangleSoup result;
  std::vector<int> number;
  for (const Vec3& point : soup.points) {
    const std::size_t before = grid.points().size();
    number.push_back(grid.number_of(point));
    if (grid.points().size() == before) result.joined.push_back(point);
  }
  result.points = grid.points();
  std::set<std::array<int, 3>> known;
  for (const std::vector<int>& polygon : soup.polygons) {
    for (auto triangle : triangles_of(soup, polygon)) {
      const Vec3& where = soup.points[static_cast<std::size_t>(triangle[0])];
      for (int& v : triangle) v = number[static_cast<std::size_t>(v)];
      auto sorted = triangle;
      std::sort(sorted.begin(), sorted.end());
      if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || !known.insert(sorted).second)
        result.left_out.push_back(where);
      else
        result.triangles.push_back(triangle);
    }
  }
  return result;
}

}  // namespace talus
