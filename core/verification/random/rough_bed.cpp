#include "verification/random/rough_bed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.hpp"
#include "mesh/structured_mesh.hpp"
#include "verification/hard_cases/shapes.hpp"

namespace talus {

RoughBed::RoughBed(SceneNumbers& numbers, int cells, double cell, double roughness, double dip)
    : cells_(cells), cell_(cell) {
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i)
      heights_.push_back(roughness * numbers.between(-1, 1) - std::tan(radians(dip)) * corner(i, j, 0).x());
}

TetMesh RoughBed::mesh(double thickness) const {
  const double base = std::ranges::min(heights_) - thickness;
  std::vector<TetMesh> columns;
  for (int j = 0; j < cells_; ++j)
    for (int i = 0; i < cells_; ++i) {
      std::array<Vec3, 8> corners;
      for (int k = 0; k < 8; ++k) {
        const int x = i + (k & 1), y = j + (k >> 1 & 1);
        corners[k] = corner(x, y, k & 4 ? height(x, y) : base);
      }
      columns.push_back(hexahedron_mesh(corners, 1, 1, 1));
    }
  return welded(columns);
}

double RoughBed::depth(const Vec3& point) const {
  const double x = point.x() / cell_ + 0.5 * cells_, y = point.y() / cell_ + 0.5 * cells_;
  if (!(x >= 0 && x < cells_ && y >= 0 && y < cells_)) return -std::numeric_limits<double>::infinity();
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const double u = x - i, v = y - j;
  const double first = height(i, j), last = height(i + 1, j + 1), middle = u > v ? height(i + 1, j) : height(i, j + 1);
  const double along_x = u > v ? middle - first : last - middle, along_y = u > v ? last - middle : middle - first;
  const double above = point.z() - (first + u * along_x + v * along_y);
  const double to_side = cell_ * std::min({x, cells_ - x, y, cells_ - y});
  return std::min(-above * cell_ / std::hypot(cell_, along_x, along_y), to_side);
}

double RoughBed::highest_within(double radius) const {
  double highest = -std::numeric_limits<double>::infinity();
  for (int j = 0; j <= cells_; ++j)
    for (int i = 0; i <= cells_; ++i)
      if (corner(i, j, 0).lpNorm<Eigen::Infinity>() < radius + cell_) highest = std::max(highest, height(i, j));
  return highest;
}

}  // namespace talus
