#include "contact/history/coupling.hpp"

#include <algorithm>

namespace talus {
namespace {

/// So often a plan is kept before it is seen whether bodies have parted: one that bounces parts for a moment. What is
/// planned for nothing costs time and changes no contact.
constexpr int patience = 32;

}  // namespace

bool Coupling::holds(int i, int j) const {
  if (i == j) return true;
  const auto pair = std::minmax(i, j);
  const Row& row = rows_[pair.first];
  return std::binary_search(pairs_.begin() + row.begin, pairs_.begin() + row.end, std::pair<int, int>(pair));
}

bool Coupling::holds(const FoundPoints& found) {
  std::vector<int>& handles = around_;
  for (const FoundPoint& p : found.points) {
    if (p.dropped) continue;
    handles.clear();
    for (int i = p.stencil_begin; i < p.stencil_end; ++i) {
      const int handle = features_.handle[found.nodes[i]];
      if (features_.movable[found.nodes[i]] && (handles.empty() || handles.back() != handle)) handles.push_back(handle);
    }
    for (std::size_t i = 1; i < handles.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!holds(handles[i], handles[j])) return false;
  }
  return true;
}

void Coupling::widen(std::span<const int> nodes, int smooth_face, std::vector<int>& widened) const {
  for (int node : nodes) {
    if (!features_.movable[node]) continue;
    widened.push_back(features_.handle[node]);
    if (features_.moves_as_one(node)) continue;
    for (int f : features_.facets_at(node)) {
      if (smooth_face >= 0 && features_.facets[f].smooth_face != smooth_face) continue;
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
  planned_.clear();
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

bool Coupling::couples(const FoundPoints& found, const FoundPoint& p) const {
  return !p.dropped && features_.movable[found.nodes[p.stencil_begin]] &&
         features_.movable[found.nodes[p.stencil_end - 1]];
}

bool Coupling::some_parted(const FoundPoints& found) {
  touch_.assign(planned_.size(), 0);
  for (const FoundPoint& p : found.points) {
    const std::pair<int, int> bodies = std::minmax(p.bodies[0], p.bodies[1]);
    const auto place = std::lower_bound(planned_.begin(), planned_.end(), bodies);
    if (couples(found, p) && place != planned_.end() && *place == bodies) touch_[place - planned_.begin()] = 1;
  }
  return std::find(touch_.begin(), touch_.end(), 0) != touch_.end();
}

void Coupling::plan_bodies(const FoundPoints& found) {
  planned_.clear();
  for (const FoundPoint& p : found.points)
    if (couples(found, p)) planned_.push_back(std::minmax(p.bodies[0], p.bodies[1]));
  std::sort(planned_.begin(), planned_.end());
  planned_.erase(std::unique(planned_.begin(), planned_.end()), planned_.end());
}

void Coupling::cover(const FoundPoints& found) {
  const bool compare = ++kept_ == patience;
  if (compare) kept_ = 0;
  if (holds(found) && !(compare && some_parted(found))) return;
  plan_bodies(found);
  forget_rows();
  pairs_.clear();
  std::vector<int>& nodes = around_;
  for (const FoundPoint& p : found.points) {
    if (p.dropped) continue;
    nodes.clear();
    int middle = p.stencil_begin;
    while (middle < p.stencil_end && found.weights[middle] > 0) ++middle;
    widen(std::span(found.nodes).subspan(p.stencil_begin, middle - p.stencil_begin), p.smooth_faces[0], nodes);
    widen(std::span(found.nodes).subspan(middle, p.stencil_end - middle), p.smooth_faces[1], nodes);
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
