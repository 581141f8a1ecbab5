#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "contact/contact_detector.hpp"
#include "contact/contact_points.hpp"

namespace talus {

/// What contacts remember from one accepted step to the next. Shear is kept as force and area, so that a corner whose
/// share of the area changes keeps its traction: no anchor points, hence no jumps when corners merge.
class ContactMemory {
 public:
  struct Memo {
    std::uint64_t key, family;
    Vec3 position, shear;  ///< m; N on the first body
    double area;           ///< m²; 0 where the contact has none
    double multiplier;     ///< N
    double slip;           ///< m
    double overlap;        ///< m, as ContactPoint's
    ContactMode mode;
    std::array<int, 2> bodies;
    bool bonded;
    bool claimed;  ///< a point of this detection goes on from it
  };

  /// Must precede recall(): gives every former contact to the point that has its key. `points` are sorted by key.
  void claim(std::span<const FoundPoint> points);

  /// The former contact that the point goes on from: that with its key, else the nearest of its family within
  /// `distance` [m]. Points with an area share a former one: what they take is a traction. Without an area they take
  /// its force, so only one may, and none if it lives on. Null where there is none.
  const Memo* recall(const FoundPoint& point, double distance);

  /// Shear force [N] of a point that goes on from `memo`, turned into the new plane with its length kept.
  static Vec3 shear_on(const Memo& memo, const FoundPoint& point);

  /// By how much forces change on the way from `memo` to the point: tractions stay.
  static double share_of(const Memo& memo, const FoundPoint& point);

  /// Whether a bond between these two patches ever broke.
  bool ever_broken(std::uint64_t family) const;

  /// Replaces everything by the outcomes of a step, but for contacts of bodies that are both `held`: they rest and are
  /// not looked for. Contacts that are open and not bonded are forgotten. `families` belong to the points.
  void accept(std::span<const ContactPoint> points, std::span<const std::uint64_t> families,
              std::span<const ContactOutcome> outcomes, const std::function<bool(int body)>& held);

 private:
  std::vector<Memo> memos_;            // sorted by key
  std::vector<int> by_family_;         // numbers of memos_, sorted by family and then along x
  std::vector<std::uint64_t> broken_;  // families, sorted
};

}  // namespace talus
