#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/broad/box.hpp"

namespace talus {

/// A tree of boxes: over the faces of one body, or over bodies. As they move, the boxes are refitted and the tree
/// stays: a block's faces keep their neighbours. Items are numbered by the place of their boxes.
class BoxTree {
 public:
  /// Builds the tree anew: items are split at the median of the longest side.
  void build(std::span<const Box> boxes);

  /// New boxes of all items, or of one.
  void refit(std::span<const Box> boxes);
  void refit(int item, std::span<const Box> boxes);

  const Box& box() const { return nodes_.front().box; }

  /// Appends every item whose box is within `distance` of `box`, in no special order.
  void within(const Box& box, double distance, std::span<const Box> boxes, std::vector<int>& stack,
              std::vector<int>& items) const;

  /// Whether the box of any other item overlaps that of `item`.
  bool any_other_within(int item, std::span<const Box> boxes, std::vector<int>& stack) const;

  /// Appends every pair of items (of this tree, of the other) whose boxes are within `distance`, in no special order.
  void pairs_within(const BoxTree& other, double distance, std::span<const Box> boxes, std::span<const Box> other_boxes,
                    std::vector<std::pair<int, int>>& stack, std::vector<std::pair<int, int>>& pairs) const;

 private:
  struct Node {
    Box box;
    int begin, end;  // of order_
    int right;       // child; the left one follows its parent; 0: a leaf
    int parent;      // of the root: −1
  };
  /// Gives every item whose box is within `distance` of this one to `take`, until that is false.
  template <class Take>
  void visit_within(const Box& box, double distance, std::span<const Box> boxes, std::vector<int>& stack,
                    Take take) const;
  int split(std::span<const Box> boxes, int begin, int end, int parent);
  void refit_node(int node, std::span<const Box> boxes);

  std::vector<int> order_;
  std::vector<int> leaf_of_;  // an item
  std::vector<Node> nodes_;
};

}  // namespace talus
