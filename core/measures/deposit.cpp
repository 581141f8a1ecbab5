#include "measures/deposit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "measures/node_places.hpp"
#include "model/number_text.hpp"

namespace talus {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double most_cells = 4e6;

/// The largest of 1, 2 and 5 · 10ᵏ of which `count` make no more than `length`.
double round_part(double length, int count) {
  const double part = length / count, power = std::pow(10, std::floor(std::log10(part)));
  for (const double figure : {5.0, 2.0})
    if (figure * power <= part) return figure * power;
  return power;
}

/// Where things lie in plan.
struct PlanBox {
  double west = std::numeric_limits<double>::infinity(), south = west, east = -west, north = -west;

  void include(const Vec3& point) {
    west = std::min(west, point.x());
    east = std::max(east, point.x());
    south = std::min(south, point.y());
    north = std::max(north, point.y());
  }
};

/// A block where it is.
struct PlacedBlock {
  const Block& block;
  std::vector<Vec3> nodes;  ///< m
};

DepthGrid grid_over(const PlanBox& box, std::optional<double> wanted) {
  if (wanted && (!(*wanted > 0) || !std::isfinite(*wanted)))
    throw InputError("cell", "the side of a cell is a length", "give metres, as 0.5");
  DepthGrid grid;
  constexpr int usual_cells = 200;
  grid.cell = wanted ? *wanted : round_part(std::max(box.east - box.west, box.north - box.south), usual_cells);
  grid.west = grid.cell * std::floor(box.west / grid.cell);
  grid.south = grid.cell * std::floor(box.south / grid.cell);
  const double columns = std::ceil((box.east - grid.west) / grid.cell),
               rows = std::ceil((box.north - grid.south) / grid.cell);
  if (columns * rows > most_cells)
    throw InputError("cell", "the grid would have " + significant(columns * rows) + " cells, more than 4 million",
                     "take larger cells than " + number_text(grid.cell) + " m");
  grid.columns = std::max(1, static_cast<int>(columns));
  grid.rows = std::max(1, static_cast<int>(rows));
  grid.depth.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), nothing);
  return grid;
}

/// Calls `take(cell, height)` for each cell whose middle lies in the triangle, seen from above.
template <class Take>
void for_cells_in(const DepthGrid& grid, const Vec3& a, const Vec3& b, const Vec3& c, Take take) {
  const double twice_area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  if (twice_area == 0) return;
  const auto [west, east] = std::minmax({a.x(), b.x(), c.x()});
  const auto [south, north] = std::minmax({a.y(), b.y(), c.y()});
  const auto number = [&](double place, double begin, int most) {
    return static_cast<int>(std::clamp(std::floor((place - begin) / grid.cell), 0.0, static_cast<double>(most - 1)));
  };
  for (int row = number(south, grid.south, grid.rows); row <= number(north, grid.south, grid.rows); ++row)
    for (int column = number(west, grid.west, grid.columns); column <= number(east, grid.west, grid.columns);
         ++column) {
      const double x = grid.west + (column + 0.5) * grid.cell, y = grid.south + (row + 0.5) * grid.cell;
      const double of_b = ((x - a.x()) * (c.y() - a.y()) - (y - a.y()) * (c.x() - a.x())) / twice_area;
      const double of_c = ((b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x())) / twice_area;
      if (of_b < 0 || of_c < 0 || of_b + of_c > 1) continue;
      take(static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column),
           a.z() + of_b * (b.z() - a.z()) + of_c * (c.z() - a.z()));
    }
}

template <class Take>
void for_cells_under(const DepthGrid& grid, const PlacedBlock& placed, Take take) {
  const auto at = [&](int node) -> const Vec3& { return placed.nodes[static_cast<std::size_t>(node)]; };
  for (const SurfaceTriangle& triangle : placed.block.surface)
    for_cells_in(grid, at(triangle.nodes[0]), at(triangle.nodes[1]), at(triangle.nodes[2]), take);
}

void fill(DepthGrid& grid, const std::vector<PlacedBlock>& moved, const std::vector<PlacedBlock>& still) {
  std::vector<double> top(grid.depth.size(), -std::numeric_limits<double>::infinity());
  std::vector<double> underside(grid.depth.size(), std::numeric_limits<double>::infinity()), ground = top;
  for (const PlacedBlock& placed : moved)
    for_cells_under(grid, placed, [&](std::size_t cell, double height) {
      top[cell] = std::max(top[cell], height);
      underside[cell] = std::min(underside[cell], height);
    });
  for (const PlacedBlock& placed : still)
    for_cells_under(grid, placed, [&](std::size_t cell, double height) {
      if (height <= top[cell]) ground[cell] = std::max(ground[cell], height);
    });
  for (std::size_t cell = 0; cell < top.size(); ++cell)
    if (std::isfinite(top[cell]))
      grid.depth[cell] = top[cell] - (std::isfinite(ground[cell]) ? ground[cell] : underside[cell]);
}

/// The outline's edges run with the deposit at their left, east, north, west or south.
class OutlineWalk {
 public:
  explicit OutlineWalk(const DepthGrid& grid)
      : grid_(grid), edges_(static_cast<std::size_t>(grid.columns + 1) * static_cast<std::size_t>(grid.rows + 1)) {
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        if (!grid.covers(column, row)) continue;
        if (!grid.covers(column, row - 1)) edge(column, row, east) = true;
        if (!grid.covers(column + 1, row)) edge(column + 1, row, north) = true;
        if (!grid.covers(column, row + 1)) edge(column + 1, row + 1, west) = true;
        if (!grid.covers(column - 1, row)) edge(column, row + 1, south) = true;
      }
  }

  std::vector<PlanRing> rings() {
    std::vector<PlanRing> all;
    for (int row = 0; row <= grid_.rows; ++row)
      for (int column = 0; column <= grid_.columns; ++column)
        for (const int direction : {east, west})
          if (edge(column, row, direction)) all.push_back(ring(column, row, direction));
    return all;
  }

 private:
  enum Direction { east, north, west, south };

  bool& edge(int column, int row, int direction) {
    return edges_[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns + 1) +
                  static_cast<std::size_t>(column)][static_cast<std::size_t>(direction)];
  }

  /// Turns left where two cells touch at a corner, so that rings cross nothing; takes the edges along.
  PlanRing ring(int column, int row, int direction) {
    constexpr std::array<int, 4> right{1, 0, -1, 0}, up{0, 1, 0, -1};
    PlanRing corners;
    const int begun = direction;
    int before = -1;
    while (edge(column, row, direction)) {
      edge(column, row, direction) = false;
      if (direction != before) corners.push_back({grid_.west + column * grid_.cell, grid_.south + row * grid_.cell});
      column += right[static_cast<std::size_t>(direction)];
      row += up[static_cast<std::size_t>(direction)];
      before = direction;
      for (const int turn : {1, 0, 3})
        if (edge(column, row, (before + turn) % 4)) {
          direction = (before + turn) % 4;
          break;
        }
    }
    if (before == begun) corners.erase(corners.begin());  // it began in the middle of a side
    return corners;
  }

  const DepthGrid& grid_;
  std::vector<std::array<bool, 4>> edges_;  ///< that leave each corner of cells
};

}  // namespace

bool DepthGrid::covers(int column, int row) const {
  return column >= 0 && row >= 0 && column < columns && row < rows && std::isfinite(at(column, row));
}

Deposit deposit_of(const BlockSystem& system, const Frame& frame, const MovedRock& rock, std::optional<double> cell) {
  Deposit deposit;
  if (rock.blocks.empty()) return deposit;
  const std::vector<std::size_t> first = first_nodes(system);
  std::vector<PlacedBlock> moved, still;
  PlanBox box;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const bool has_moved = std::ranges::binary_search(rock.blocks, static_cast<int>(b));
    PlacedBlock placed{system.blocks[b], places(system.blocks[b], first[b], frame)};
    if (has_moved)
      for (const Vec3& node : placed.nodes) box.include(node);
    (has_moved ? moved : still).push_back(std::move(placed));
  }
  deposit.grid = grid_over(box, cell);
  fill(deposit.grid, moved, still);
  deposit.outline = OutlineWalk(deposit.grid).rings();
  const double of_cell = deposit.grid.cell * deposit.grid.cell;
  for (const double depth : deposit.grid.depth) {
    if (!std::isfinite(depth)) continue;
    deposit.area += of_cell;
    deposit.bulk += of_cell * depth;
    deposit.max_depth = std::max(deposit.max_depth, depth);
  }
  if (deposit.area > 0) deposit.mean_depth = deposit.bulk / deposit.area;
  return deposit;
}

}  // namespace talus
