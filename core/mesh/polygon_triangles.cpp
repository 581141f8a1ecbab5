#include "mesh/polygon_triangles.hpp"

#include <Eigen/Geometry>
#include <cstddef>

namespace talus {
namespace {

/// Corners of a polygon that loses one after the other.
class ShrinkingPolygon {
 public:
  ShrinkingPolygon(const std::vector<Vec3>& vertices, std::vector<int> corners)
      : vertices_(vertices), corners_(std::move(corners)) {
    for (std::size_t k = 1; k + 1 < corners_.size(); ++k) normal_ += (at(k) - at(0)).cross(at(k + 1) - at(0));
  }

  std::size_t size() const { return corners_.size(); }

  std::array<int, 3> triangle_at(std::size_t k) const { return {corners_[before(k)], corners_[k], corners_[after(k)]}; }

  /// The triangle at a corner that bends outwards and holds no other corner; the one that bends most where rounding
  /// leaves none.
  std::size_t ear() const {
    std::size_t best = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      if (bend(k) > 0 && is_free(k)) return k;
      if (bend(k) > bend(best)) best = k;
    }
    return best;
  }

  void remove(std::size_t k) { corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(k)); }

 private:
  std::size_t before(std::size_t k) const { return (k + size() - 1) % size(); }
  std::size_t after(std::size_t k) const { return (k + 1) % size(); }
  const Vec3& at(std::size_t k) const { return vertices_[static_cast<std::size_t>(corners_[k])]; }
  double turn(const Vec3& a, const Vec3& b, const Vec3& c) const { return normal_.dot((b - a).cross(c - a)); }
  double bend(std::size_t k) const { return turn(at(before(k)), at(k), at(after(k))); }

  bool is_free(std::size_t k) const {
    const Vec3 &a = at(before(k)), &b = at(k), &c = at(after(k));
    for (std::size_t i = 0; i < size(); ++i) {
      if (i == before(k) || i == k || i == after(k)) continue;
      const Vec3& p = at(i);
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  const std::vector<Vec3>& vertices_;
  std::vector<int> corners_;
  Vec3 normal_ = Vec3::Zero();
};

}  // namespace

std::vector<std::array<int, 3>> polygon_triangles(const std::vector<Vec3>& vertices, std::vector<int> face) {
  std::vector<std::array<int, 3>> triangles;
  ShrinkingPolygon rest(vertices, std::move(face));
  while (rest.size() >= 3) {
    const std::size_t ear = rest.ear();
    triangles.push_back(rest.triangle_at(ear));
    rest.remove(ear);
  }
  return triangles;
}

}  // namespace talus
