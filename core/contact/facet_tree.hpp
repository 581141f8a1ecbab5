#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/box.hpp"

namespace talus {

/// A tree of boxes over the facets of one body. Built once; as the body moves and deforms, the boxes are refitted and
/// the tree stays: a block's facets keep their neighbours.
class FacetTree {
 public:
  /// Facets `first` … `first + boxes.size()` with their boxes, split at the median of the longest side.
  FacetTree(int first, std::span<const Box> boxes);

  /// New boxes, in the order of the facets.
  void refit(std::span<const Box> boxes);

  const Box& box() const { return nodes_.front().box; }

  /// Appends every pair of facets (of this tree, of the other) whose boxes are within `distance`, in no special order.
  void pairs_within(const FacetTree& other, double distance, std::span<const Box> boxes,
                    std::span<const Box> other_boxes, std::vector<std::pair<int, int>>& stack,
                    std::vector<std::pair<int, int>>& pairs) const;

 private:
  struct Node {
    Box box;
    int begin, end;  // of order_
    int right;       // child; the left one follows its parent; 0: a leaf
  };
  int build(std::span<const Box> boxes, int begin, int end);

  int first_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace talus
