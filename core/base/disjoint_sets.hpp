#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace talus {

/// Numbers from 0 that belong together or not (union-find; paths are halved, Tarjan & van Leeuwen 1984).
class DisjointSets {
 public:
  /// Each by itself.
  void reset(int size) {
    lower_.resize(size);
    std::iota(lower_.begin(), lower_.end(), 0);
  }
  int size() const { return static_cast<int>(lower_.size()); }
  /// The lowest number of the set.
  int first_of(int number) {
    while (lower_[number] != number) number = lower_[number] = lower_[lower_[number]];
    return number;
  }
  void join(int a, int b) {
    a = first_of(a);
    b = first_of(b);
    lower_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> lower_;  ///< a lower number of the same set, or the number itself
};

}  // namespace talus
