#pragma once

#include <vector>

#include "mesh/tet_mesh.hpp"
#include "verification/random/scene_numbers.hpp"

namespace talus {

/// A bed whose height is drawn at each corner of a square grid about the origin, and linear in the two triangles that
/// the diagonal along (1, 1) divides a cell into: a mountainside as a scan has it.
class RoughBed {
 public:
  /// Heights differ by `roughness` [m] from a plane that falls by tan(dip) along x; cells [m], so many each way.
  RoughBed(SceneNumbers& numbers, int cells, double cell, double roughness, double dip);

  /// From its surface down to a flat base that is `thickness` [m] below its lowest corner.
  TetMesh mesh(double thickness) const;
  /// How far the point lies behind the triangle that is above or below it, or from the bed's side if that is nearer
  /// [m]; negative where it lies before it, −infinity beside the bed.
  double depth(const Vec3& point) const;
  /// Of all corners that are not farther than `radius` from the origin along x or y, and those around them [m].
  double highest_within(double radius) const;

 private:
  double height(int i, int j) const { return heights_[static_cast<std::size_t>(j * (cells_ + 1) + i)]; }
  Vec3 corner(int i, int j, double z) const { return {cell_ * (i - 0.5 * cells_), cell_ * (j - 0.5 * cells_), z}; }

  int cells_;
  double cell_;
  std::vector<double> heights_;  // m, rows along x
};

}  // namespace talus
