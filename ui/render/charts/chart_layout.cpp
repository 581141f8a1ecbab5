#include "render/charts/chart_layout.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace talus {

namespace {

bool meet(const MarkLabel& a, const MarkLabel& b, double gap) {
  return a.left < b.left + b.width + gap && b.left < a.left + a.width + gap;
}

bool reaches_over(const MarkLabel& label, double line, double gap) {
  return label.left - gap < line && line < label.left + label.width + gap;
}

}  // namespace

int arrange(std::span<MarkLabel> labels, double gap, double right_end) {
  std::vector<MarkLabel*> right, left;
  for (MarkLabel& label : labels) {
    label.row = 0;
    const bool fits = label.line + gap + label.width <= right_end;
    label.left = fits ? label.line + gap : label.line - gap - label.width;
    (fits ? right : left).push_back(&label);
  }
  // From the right, then those on the left of their lines from the left: each lies above all it has met or spans.
  std::reverse(right.begin(), right.end());
  right.insert(right.end(), left.begin(), left.end());
  int rows = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    MarkLabel& label = *right[i];
    for (std::size_t k = 0; k < i; ++k)
      if (meet(label, *right[k], 2 * gap) || reaches_over(label, right[k]->line, gap))
        label.row = std::max(label.row, right[k]->row + 1);
    rows = std::max(rows, label.row + 1);
  }
  return rows;
}

std::vector<double> spread(const std::vector<double>& heights, double spacing, double low, double high) {
  std::vector<std::size_t> order(heights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
  // Neighbours that are too close form a group around their mean; groups that then meet are joined.
  struct Group {
    double sum = 0;
    int count = 0;
    double middle(double gap, double bottom, double top) const {
      const double half = (count - 1) * gap / 2;
      return std::max(std::min(sum / count, top - half), bottom + half);
    }
  };
  std::vector<Group> groups;
  for (const std::size_t i : order) {
    groups.push_back({heights[i], 1});
    while (groups.size() > 1) {
      const Group& last = groups.back();
      Group& before = groups[groups.size() - 2];
      const double needed = (last.count + before.count) * spacing / 2;
      if (last.middle(spacing, low, high) - before.middle(spacing, low, high) >= needed) break;
      before.sum += last.sum;
      before.count += last.count;
      groups.pop_back();
    }
  }
  std::vector<double> placed(heights.size());
  auto next = order.begin();
  for (const Group& group : groups) {
    const double middle = group.middle(spacing, low, high);
    for (int k = 0; k < group.count; ++k) placed[*next++] = middle + (k - (group.count - 1) / 2.0) * spacing;
  }
  return placed;
}

std::vector<PixelPoint> simplified(const std::vector<PixelPoint>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, points.size() - 1}};
  while (!spans.empty()) {
    const auto [first, last] = spans.back();
    spans.pop_back();
    const PixelPoint a = points[first], b = points[last];
    const double dx = b.x - a.x, dy = b.y - a.y, length_squared = dx * dx + dy * dy;
    double farthest = tolerance;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double px = points[i].x - a.x, py = points[i].y - a.y;
      const double along = length_squared > 0 ? std::clamp((px * dx + py * dy) / length_squared, 0.0, 1.0) : 0;
      const double distance = std::hypot(px - along * dx, py - along * dy);
      if (distance <= farthest) continue;
      farthest = distance;
      split = i;
    }
    if (split == first) continue;
    kept[split] = true;
    spans.push_back({first, split});
    spans.push_back({split, last});
  }
  std::vector<PixelPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  return result;
}

}  // namespace talus
