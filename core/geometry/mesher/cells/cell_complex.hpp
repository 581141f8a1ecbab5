#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "geometry/mesher/plane.hpp"

namespace talus {

/// The mark of a face that parts two cells of one block.
constexpr int between_cells = -1;

/// A flat face of a cell: corners counter-clockwise seen from outside the cell.
struct CellFace {
  std::vector<int> corners;
  int mark = between_cells;  ///< the number of the flat face of the solid, or of the joint, that it lies on
};

/// A convex polyhedron.
using Cell = std::vector<CellFace>;

/// Convex cells that fill a solid and share the vertices of their common faces: a face that parts two cells has the
/// same corners in both. Cutting keeps that so, which makes volumes exact and faces fit to the last digit.
class CellComplex {
 public:
  CellComplex() = default;
  /// `reach`: m, so near a vertex lies on a plane.
  CellComplex(std::vector<Vec3> vertices, std::vector<Cell> cells, double reach);

  /// Divides every cell that lies on both sides of the plane. New faces, and those on the plane that lie on no joint
  /// yet (their mark is below `first_joint`), get `mark`. Returns whether there is any such face.
  bool cut(const Plane& plane, int mark, int first_joint);

  const std::vector<Vec3>& vertices() const { return vertices_; }
  const std::vector<Cell>& cells() const { return cells_; }
  const Vec3& vertex(int index) const { return vertices_[static_cast<std::size_t>(index)]; }

 private:
  std::vector<Vec3> vertices_;
  std::vector<Cell> cells_;
  std::vector<Eigen::AlignedBox3d> boxes_;  ///< around each cell: most lie far from a plane
  double reach_ = 0;
};

/// m³ of a cell, about one of its corners.
double volume_of(const Cell& cell, const std::vector<Vec3>& vertices);

/// Whether the point lies in the cell or on its border.
bool holds(const Cell& cell, const std::vector<Vec3>& vertices, const Vec3& point);

/// m², along the outward normal.
Vec3 area_of(const CellFace& face, const std::vector<Vec3>& vertices);

}  // namespace talus
