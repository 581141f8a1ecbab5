#pragma once

#include <limits>
#include <utility>

#include "contact/broad/box_tree.hpp"
#include "contact/passage/convex_pieces.hpp"

namespace talus {

/// Which bodies, and which of their pieces, are near each other: by boxes around where they are in a span of time.
class NearPieces {
 public:
  explicit NearPieces(const ConvexPieces& pieces) : pieces_(pieces), of_pieces_(pieces.bodies()) {}

  /// The span goes from the nodes' positions at its start to those at its end [m], on whatever way that leaves no box
  /// around both. Fixed bodies that are where they were in the span before cost nothing.
  void set_span(std::span<const Vec3> start, std::span<const Vec3> end, const BodySet& bodies);

  /// Bodies other than `body` whose boxes meet its own.
  std::span<const int> near(int body);
  /// Pairs of pieces of two bodies whose boxes meet.
  std::span<const std::pair<int, int>> near(int body_a, int body_b);

 private:
  struct Pieces {
    bool built = false, fits = false;
    std::vector<Box> boxes;
    BoxTree tree;
    Vec3 stood_at = Vec3::Constant(std::numeric_limits<double>::infinity());  // m, the first node of a fixed body
  };
  bool still_stands(const Body& body, Pieces& own) const;
  const Pieces& fitted(int body);
  Box box_around(std::span<const int> nodes) const;

  const ConvexPieces& pieces_;
  std::span<const Vec3> start_, end_;
  std::vector<Box> bodies_;
  BoxTree tree_;
  std::vector<Pieces> of_pieces_;  // a body
  std::vector<int> stack_, found_;
  std::vector<std::pair<int, int>> pair_stack_, pairs_;
};

}  // namespace talus
