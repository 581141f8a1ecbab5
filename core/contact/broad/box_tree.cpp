#include "contact/broad/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace talus {
namespace {

constexpr int leaf_size = 4;  // items; fewer cost refitting, more cost tests

}  // namespace

void BoxTree::build(std::span<const Box> boxes) {
  order_.resize(boxes.size());
  leaf_of_.resize(boxes.size());
  nodes_.clear();
  std::iota(order_.begin(), order_.end(), 0);
  split(boxes, 0, static_cast<int>(boxes.size()), -1);
}

int BoxTree::split(std::span<const Box> boxes, int begin, int end, int parent) {
  const int node = static_cast<int>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0, parent});
  for (int i = begin; i < end; ++i) nodes_[node].box.add(boxes[order_[i]]);
  if (end - begin <= leaf_size) {
    for (int i = begin; i < end; ++i) leaf_of_[order_[i]] = node;
    return node;
  }
  int axis = 0;
  (nodes_[node].box.upper - nodes_[node].box.lower).maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int i, int j) {
    const double a = boxes[i].lower[axis] + boxes[i].upper[axis], b = boxes[j].lower[axis] + boxes[j].upper[axis];
    return a != b ? a < b : i < j;
  });
  split(boxes, begin, middle, node);
  const int right = split(boxes, middle, end, node);
  nodes_[node].right = right;
  return node;
}

void BoxTree::refit_node(int n, std::span<const Box> boxes) {
  Node& node = nodes_[n];
  node.box = {};
  if (node.right) {
    node.box.add(nodes_[n + 1].box);
    node.box.add(nodes_[node.right].box);
  } else {
    for (int i = node.begin; i < node.end; ++i) node.box.add(boxes[order_[i]]);
  }
}

void BoxTree::refit(std::span<const Box> boxes) {
  for (int n = static_cast<int>(nodes_.size()) - 1; n >= 0; --n) refit_node(n, boxes);  // children after their parents
}

void BoxTree::refit(int item, std::span<const Box> boxes) {
  for (int n = leaf_of_[item]; n >= 0; n = nodes_[n].parent) refit_node(n, boxes);
}

template <class Take>
void BoxTree::visit_within(const Box& box, double distance, std::span<const Box> boxes, std::vector<int>& stack,
                           Take take) const {
  stack.assign(1, 0);
  while (!stack.empty()) {
    const int n = stack.back();
    const Node& node = nodes_[n];
    stack.pop_back();
    if (!node.box.within(box, distance)) continue;
    if (node.right) {
      stack.push_back(n + 1);
      stack.push_back(node.right);
      continue;
    }
    for (int i = node.begin; i < node.end; ++i)
      if (boxes[order_[i]].within(box, distance) && !take(order_[i])) return;
  }
}

void BoxTree::within(const Box& box, double distance, std::span<const Box> boxes, std::vector<int>& stack,
                     std::vector<int>& items) const {
  visit_within(box, distance, boxes, stack, [&](int item) {
    items.push_back(item);
    return true;
  });
}

bool BoxTree::any_other_within(int item, std::span<const Box> boxes, std::vector<int>& stack) const {
  bool any = false;
  visit_within(boxes[item], 0, boxes, stack, [&](int other) {
    any = other != item;
    return !any;
  });
  return any;
}

void BoxTree::pairs_within(const BoxTree& other, double distance, std::span<const Box> boxes,
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
            pairs.emplace_back(order_[p], other.order_[q]);
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
