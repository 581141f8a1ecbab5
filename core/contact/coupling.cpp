#include "contact/coupling.hpp"

#include <algorithm>

namespace talus {

bool Coupling::holds(int i, int j) const {
  if (i == j) return true;
  const auto pair = std::minmax(i, j);
  const Row& row = rows_[pair.first];
  return std::binary_search(pairs_.begin() + row.begin, pairs_.begin() + row.end, std::pair<int, int>(pair));
}

bool Coupling::holds(const FoundPoints& found) const {
  const auto handle = [&](int i) { return features_.handle[found.nodes[i]]; };
  for (const FoundPoint& p : found.points) {
    if (p.dropped) continue;
    for (int i = p.stencil_begin; i < p.stencil_end; ++i) {
      if (!features_.movable[found.nodes[i]]) continue;
      for (int j = p.stencil_begin; j < i; ++j) {
        if (features_.movable[found.nodes[j]] && !holds(handle(i), handle(j))) return false;
      }
    }
  }
  return true;
}

void Coupling::widen(std::span<const int> nodes, int patch, std::vector<int>& widened) const {
  for (int node : nodes) {
    if (!features_.movable[node]) continue;
    widened.push_back(features_.handle[node]);
    for (int f : features_.facets_at(node)) {
      if (patch >= 0 && features_.facets[f].patch != patch) continue;
      for (int n : features_.facets[f].nodes) widened.push_back(features_.handle[n]);
    }
  }
}

void Coupling::forget_rows() {
  for (const auto& pair : pairs_) rows_[pair.first] = {};
}

void Coupling::index_rows() {
  for (int i = 0; i < static_cast<int>(pairs_.size()); ++i) {
    Row& row = rows_[pairs_[i].first];
    if (row.end == 0) row.begin = i;
    row.end = i + 1;
  }
}

void Coupling::clear() {
  forget_rows();
  pairs_.clear();
  ++generation_;
}

void Coupling::drop_immovable() {
  const auto immovable = [&](const auto& pair) {
    return !features_.movable[pair.first] || !features_.movable[pair.second];
  };
  if (std::none_of(pairs_.begin(), pairs_.end(), immovable)) return;
  forget_rows();
  std::erase_if(pairs_, immovable);
  index_rows();
  ++generation_;
}

void Coupling::cover(const FoundPoints& found) {
  if (holds(found)) return;
  forget_rows();
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
  index_rows();
  ++generation_;
}

}  // namespace talus
