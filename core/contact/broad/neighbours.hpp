#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/broad/face_boxes.hpp"
#include "contact/reach.hpp"

namespace talus {

/// Which pairs of bodies may come within their search distance before one of the two leaves the box it was given: its
/// own, what it reaches and a margin for the steps to come. Only what leaves its box is looked at, and what was set
/// down or woken; of pairs at rest (fixed or asleep both) nothing is known.
class Neighbours {
 public:
  explicit Neighbours(std::size_t bodies) : bodies_(bodies) {}

  /// How wide a body's search distance may be at least [m], whoever the other is, its mesh size [m], and whether it
  /// rests. Its pairs are sought anew.
  struct Stance {
    double least_distance = 0, size = 0;
    bool rests = false;
  };
  void set(int body, const Stance& stance);

  /// Follows what has moved, for search distances up to `reach` or what a body has as its least. Returns whether
  /// pairs() changed.
  bool follow(std::span<const Vec3> x, const Reach& reach, const Odometers& odometers, FaceBoxes& faces);

  /// Sorted, the lower number first.
  std::span<const std::pair<int, int>> pairs() const { return pairs_; }

 private:
  struct Body {
    Stance stance;
    double leaves_at = -1;      // the reading of its odometer up to which it is in its box
    double planned_reach = -1;  // m, its part that its box is wide enough for
    bool is_due = false;
  };
  void make_due(int body);
  void plan_for(int body, double reach);
  void give_box(int body, std::span<const Vec3> x, const Odometers& odometers, FaceBoxes& faces);
  void rebuild_or_refit();
  void find_pairs();

  std::vector<Body> bodies_;
  std::vector<Box> boxes_;  // a body: with its margin and what it reaches
  BoxTree tree_;
  std::size_t refitted_ = 0;  // boxes since the tree was built
  std::vector<int> due_;      // bodies whose pairs are sought anew
  std::vector<int> reboxed_, stack_, found_;
  std::vector<std::pair<int, int>> pairs_, fresh_;
};

}  // namespace talus
