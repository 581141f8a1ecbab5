#pragma once

#include <array>
#include <compare>
#include <span>
#include <vector>

#include "contact/contact_point.hpp"

namespace talus {

class ContactMemory;

/// Springs that go on in others, or in more of the area. Corners of faces come and go and share the area anew, and what
/// bore nothing takes the traction beside it: between two bodies none of that may make energy.
class SpringHandover {
 public:
  /// Springs that hold more than in their own past hold together no more than those gave that have ended or have less
  /// of the area: else their strain is made less, of all by one factor in compression and by one in shear. `points` go
  /// on from what `memory` knows, sorted by key; `numbers` are theirs among the points found.
  void limit(const ContactMemory& memory, std::span<const int> numbers, std::span<ContactPoint> points);

 private:
  /// A point that goes on from more than its own past.
  struct Successor {
    std::array<int, 2> bodies;
    int point;
    double gained;  // – of what it holds
    auto operator<=>(const Successor&) const = default;
  };
  void find_successors(const ContactMemory& memory, std::span<const int> numbers, std::span<const ContactPoint> points);

  std::vector<Successor> successors_;  // by bodies
};

}  // namespace talus
