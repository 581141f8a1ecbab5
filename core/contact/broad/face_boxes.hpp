#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/broad/box_tree.hpp"
#include "contact/broad/measured_once.hpp"
#include "contact/broad/odometers.hpp"
#include "contact/contact_features.hpp"

namespace talus {

/// Boxes of the faces, and the trees of boxes of the bodies: each measured when it is asked for and its
/// body has moved since, so that what stays where it is, or is far from everything, is not measured at all.
class FaceBoxes {
 public:
  /// Both outlive this.
  FaceBoxes(const ContactFeatures& features, const Odometers& odometers);

  /// The boxes of these bodies' faces are to be measured anew, once they are asked for.
  void forget(std::span<const int> bodies);
  /// Brings all boxes of a body and its tree up to date at the positions x.
  void refit(int body, std::span<const Vec3> x);
  /// Brings the box of one face up to date; on several threads at once if need be.
  void refresh(int face, std::span<const Vec3> x);

  /// As of the last refit of the body: appends the pairs of faces of a and b whose boxes are within `distance`.
  void pairs_within(int body_a, int body_b, double distance, std::vector<std::pair<int, int>>& pairs);
  /// The box of a body as of its last refit, …
  const Box& box_of(int body) const { return trees_[body].box(); }
  /// … and how far the body may have gone since. [m]
  double gone_since(int body) const { return odometers_.travelled(body) - refitted_at_[body].travelled; }

  /// The largest coordinate of a body as of then [m]; 0 if there was no refit.
  double farthest_coordinate(int body) const;

  const Box& box(int face) const { return boxes_[face]; }

 private:
  struct Reading {
    double travelled = 0;
    std::uint64_t moves = never;
  };
  static constexpr std::uint64_t never = ~std::uint64_t{0};
  std::span<const Box> boxes_of(int body) const;
  Box measure(int face, std::span<const Vec3> x) const;

  const ContactFeatures& features_;
  const Odometers& odometers_;
  std::vector<Box> boxes_;               // a face
  std::vector<MeasuredOnce> refreshed_;  // a face
  std::vector<BoxTree> trees_;           // a body
  std::vector<Reading> refitted_at_;     // a body
  std::vector<std::pair<int, int>> stack_;
};

}  // namespace talus
