#pragma once

#include <algorithm>

namespace talus {

/// When to try what may be in vain: always, until it is; then one chance is left out, after the next failure three, and
/// so on up to 31, until it succeeds again.
class Trials {
 public:
  /// Whether to try now. If so, the outcome is to be noted.
  bool is_due() { return left_out_++ >= to_leave_out_; }
  void note(bool succeeded) {
    left_out_ = 0;
    to_leave_out_ = succeeded ? 0 : std::min(2 * to_leave_out_ + 1, 31);
  }
  void archive(auto& state) { state(left_out_, to_leave_out_); }

 private:
  int left_out_ = 0, to_leave_out_ = 0;
};

}  // namespace talus
