#include "contact/facet_tree.hpp"

#include <algorithm>
#include <numeric>

namespace talus {
namespace {

constexpr int leaf_size = 4;  // facets; fewer cost refitting, more cost tests

}  // namespace

FacetTree::FacetTree(int first, std::span<const Box> boxes) : first_(first), order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  build(boxes, 0, static_cast<int>(boxes.size()));
}

int FacetTree::build(std::span<const Box> boxes, int begin, int end) {
  const int node = static_cast<int>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0});
  for (int i = begin; i < end; ++i) nodes_[node].box.add(boxes[order_[i]]);
  if (end - begin <= leaf_size) return node;

  int axis = 0;
  (nodes_[node].box.upper - nodes_[node].box.lower).maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int i, int j) {
    const double a = boxes[i].lower[axis] + boxes[i].upper[axis], b = boxes[j].lower[axis] + boxes[j].upper[axis];
    return a != b ? a < b : i < j;
  });
  build(boxes, begin, middle);
  const int right = build(boxes, middle, end);
  nodes_[node].right = right;
  return node;
}

void FacetTree::refit(std::span<const Box> boxes) {
  for (int n = static_cast<int>(nodes_.size()) - 1; n >= 0; --n) {  // children come after their parents
    Node& node = nodes_[n];
    node.box = {};
    if (node.right) {
      node.box.add(nodes_[n + 1].box);
      node.box.add(nodes_[node.right].box);
    } else {
      for (int i = node.begin; i < node.end; ++i) node.box.add(boxes[order_[i]]);
    }
  }
}

void FacetTree::pairs_within(const FacetTree& other, double distance, std::span<const Box> boxes,
                             std::span<const Box> other_boxes, std::vector<std::pair<int, int>>& stack,
                             std::vector<std::pair<int, int>>& pairs) const {
  stack.assign(1, {0, 0});
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    const Node &a = nodes_[i], &b = other.nodes_[j];
    if (!a.box.within(b.box, distance)) continue;
    if (!a.right && !b.right) {
      for (int p = a.begin; p < a.end; ++p) {
        for (int q = b.begin; q < b.end; ++q) {
          if (boxes[order_[p]].within(other_boxes[other.order_[q]], distance)) {
            pairs.emplace_back(first_ + order_[p], other.first_ + other.order_[q]);
          }
        }
      }
    } else if (b.right == 0 || (a.right != 0 && a.end - a.begin >= b.end - b.begin)) {
      stack.emplace_back(i + 1, j);
      stack.emplace_back(a.right, j);
    } else {
      stack.emplace_back(i, j + 1);
      stack.emplace_back(i, b.right);
    }
  }
}

}  // namespace talus
