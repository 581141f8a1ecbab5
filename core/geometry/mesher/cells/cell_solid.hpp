#pragma once

#include <vector>

#include "geometry/mesher/cells/cell_complex.hpp"

namespace talus {

/// A solid as convex cells, cut along joints.
struct CellSolid {
  CellComplex complex;
  std::vector<int> joints;               ///< of each mark of a face: index into Project::joints; −1: on no cut
  std::vector<std::vector<int>> across;  ///< of each cell and face, the cell on the other side; −1: none
};

/// The cells on the other side of each cell's faces; −1: none.
std::vector<std::vector<int>> cells_across(const CellComplex& complex);

}  // namespace talus
