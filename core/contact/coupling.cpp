#include "contact/coupling.hpp"

#include <algorithm>

namespace talus {

bool Coupling::holds(int i, int j) const {
  if (i == j) return true;
  if (row_begin_.empty()) return false;
  const auto pair = std::minmax(i, j);
  const auto begin = pairs_.begin() + row_begin_[pair.first], end = pairs_.begin() + row_begin_[pair.first + 1];
  return std::binary_search(begin, end, std::pair<int, int>(pair));
}

bool Coupling::holds(const FoundPoints& found) const {
  for (const FoundPoint& p : found.points) {
    if (p.dropped) continue;
    for (int i = p.stencil_begin; i < p.stencil_end; ++i) {
      if (!features_.movable[found.nodes[i]]) continue;
      for (int j = p.stencil_begin; j < i; ++j) {
        if (features_.movable[found.nodes[j]] && !holds(found.nodes[i], found.nodes[j])) return false;
      }
    }
  }
  return true;
}

void Coupling::widen(std::span<const int> nodes, int patch, std::vector<int>& widened) const {
  for (int node : nodes) {
    if (!features_.movable[node]) continue;
    widened.push_back(node);
    for (int f : features_.facets_at(node)) {
      if (patch >= 0 && features_.facets[f].patch != patch) continue;
      widened.insert(widened.end(), features_.facets[f].nodes.begin(), features_.facets[f].nodes.end());
    }
  }
}

void Coupling::clear() {
  pairs_.clear();
  row_begin_.clear();
  ++generation_;
}

void Coupling::cover(const FoundPoints& found) {
  if (holds(found)) return;
  pairs_.clear();
  std::vector<int> nodes;
  for (const FoundPoint& p : found.points) {
    if (p.dropped) continue;
    nodes.clear();
    int middle = p.stencil_begin;
    while (middle < p.stencil_end && found.weights[middle] > 0) ++middle;
    widen(std::span(found.nodes).subspan(p.stencil_begin, middle - p.stencil_begin), p.patches[0], nodes);
    widen(std::span(found.nodes).subspan(middle, p.stencil_end - middle), p.patches[1], nodes);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = i + 1; j < nodes.size(); ++j) pairs_.emplace_back(nodes[i], nodes[j]);
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  row_begin_.assign(features_.node_count() + 1, 0);
  for (const auto& pair : pairs_) ++row_begin_[pair.first + 1];
  for (std::size_t i = 1; i < row_begin_.size(); ++i) row_begin_[i] += row_begin_[i - 1];
  ++generation_;
}

}  // namespace talus
