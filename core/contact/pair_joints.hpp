#pragma once

#include <algorithm>
#include <map>
#include <utility>

namespace talus {

/// For every two bodies the joint that holds where their facets lie on no common joint plane: a usual one, and others
/// of some pairs. Numbers of joint laws.
class PairJoints {
 public:
  explicit PairJoints(int usual = 0) : usual_(usual) {}
  void set(int body_a, int body_b, int joint) { others_[std::minmax(body_a, body_b)] = joint; }
  int of(int body_a, int body_b) const {
    if (others_.empty()) return usual_;
    const auto other = others_.find(std::minmax(body_a, body_b));
    return other == others_.end() ? usual_ : other->second;
  }

 private:
  int usual_;
  std::map<std::pair<int, int>, int> others_;
};

}  // namespace talus
