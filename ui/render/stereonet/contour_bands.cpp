#include "render/stereonet/contour_bands.hpp"

#include <array>
#include <cstddef>

namespace talus {
namespace {

struct Node {
  Vec2 at;
  double above = 0;  ///< value less the level
};

class Cells {
 public:
  Cells(std::span<const double> values, int size, double level) : values_(values), size_(size), level_(level) {}

  Node node(int column, int row) const {
    const auto index =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column);
    return {Vec2(2.0 * column / (size_ - 1) - 1, 2.0 * row / (size_ - 1) - 1), values_[index] - level_};
  }

  /// Corners of a cell, counter-clockwise from its lower left.
  std::array<Node, 4> corners(int column, int row) const {
    return {node(column, row), node(column + 1, row), node(column + 1, row + 1), node(column, row + 1)};
  }

 private:
  std::span<const double> values_;
  int size_;
  double level_;
};

/// Where the value between two nodes is that of the level.
Vec2 crossing(const Node& a, const Node& b) { return a.at + (b.at - a.at) * (a.above / (a.above - b.above)); }

/// The part of a triangle above the level.
NetPolygon clipped(const std::array<Node, 3>& triangle) {
  NetPolygon part;
  for (std::size_t i = 0; i < 3; ++i) {
    const Node &a = triangle[i], &b = triangle[(i + 1) % 3];
    if (a.above >= 0) part.push_back(a.at);
    if ((a.above >= 0) != (b.above >= 0)) part.push_back(crossing(a, b));
  }
  return part;
}

NetPolygon border(const std::array<Node, 3>& triangle) {
  NetPolygon line;
  for (std::size_t i = 0; i < 3; ++i) {
    const Node &a = triangle[i], &b = triangle[(i + 1) % 3];
    if ((a.above >= 0) != (b.above >= 0)) line.push_back(crossing(a, b));
  }
  return line;
}

std::array<std::array<Node, 3>, 2> triangles_of(const std::array<Node, 4>& c) {
  return {{{c[0], c[1], c[2]}, {c[0], c[2], c[3]}}};
}

int count_above(const std::array<Node, 4>& corners) {
  int count = 0;
  for (const Node& corner : corners) count += corner.above >= 0 ? 1 : 0;
  return count;
}

}  // namespace

std::vector<NetPolygon> region_above(std::span<const double> values, int size, double level) {
  const Cells cells(values, size, level);
  std::vector<NetPolygon> region;
  for (int row = 0; row + 1 < size; ++row) {
    int run_start = -1;  // neighbours that are all above become one rectangle
    const auto end_run = [&](int column) {
      if (run_start >= 0)
        region.push_back({cells.node(run_start, row).at, cells.node(column, row).at, cells.node(column, row + 1).at,
                          cells.node(run_start, row + 1).at});
      run_start = -1;
    };
    for (int column = 0; column + 1 < size; ++column) {
      const std::array<Node, 4> corners = cells.corners(column, row);
      const int above = count_above(corners);
      if (above == 4) {
        if (run_start < 0) run_start = column;
        continue;
      }
      end_run(column);
      if (above == 0) continue;
      for (const auto& triangle : triangles_of(corners))
        if (NetPolygon part = clipped(triangle); part.size() > 2) region.push_back(std::move(part));
    }
    end_run(size - 1);
  }
  return region;
}

std::vector<NetPolygon> contour_lines(std::span<const double> values, int size, double level) {
  const Cells cells(values, size, level);
  std::vector<NetPolygon> lines;
  for (int row = 0; row + 1 < size; ++row)
    for (int column = 0; column + 1 < size; ++column) {
      const std::array<Node, 4> corners = cells.corners(column, row);
      if (const int above = count_above(corners); above == 0 || above == 4) continue;
      for (const auto& triangle : triangles_of(corners))
        if (NetPolygon line = border(triangle); line.size() == 2) lines.push_back(std::move(line));
    }
  return lines;
}

}  // namespace talus
