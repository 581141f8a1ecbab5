#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "measures/run_out.hpp"

namespace talus {

/// Values on a level grid of square cells, of which each stands for its middle.
struct DepthGrid {
  double west = 0, south = 0;  ///< m, the corner of the first cell
  double cell = 1;             ///< m
  int columns = 0, rows = 0;
  std::vector<double> depth;  ///< m, rows from south to north; NaN where no deposit lies

  double at(int column, int row) const { return depth[static_cast<std::size_t>(row) * columns + column]; }
  bool covers(int column, int row) const;  ///< false outside of the grid, too
};

/// A closed polygon in plan, m; its last corner is followed by the first one.
using PlanRing = std::vector<std::array<double, 2>>;

/// The rock that moved, where it lies.
struct Deposit {
  /// Of each cell the height of the deposit's top above the highest rock below it that has not moved, or, where there
  /// is none, above the deposit's own underside.
  DepthGrid grid;
  std::vector<PlanRing> outline;  ///< anticlockwise, and clockwise around what it leaves free; along edges of cells
  double area = 0;                ///< m², of the cells that it covers
  double bulk = 0;                ///< m³, depth times area: rock and the voids in and below it
  double mean_depth = 0, max_depth = 0;  ///< m
};

/// `cell` [m]; none: a round length, of which some 200 make the deposit's longer side. Throws InputError for one that
/// is no length, or for which the grid would have more than four million cells.
Deposit deposit_of(const BlockSystem& system, const Frame& frame, const MovedRock& rock,
                   std::optional<double> cell = {});

}  // namespace talus
