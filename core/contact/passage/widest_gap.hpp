#pragma once

#include "contact/passage/convex_pieces.hpp"

namespace talus {

/// A convex piece somewhere: its corners and the outward unit normals of its faces.
struct PlacedPiece {
  const ConvexShape* shape = nullptr;
  std::vector<Vec3> corners, normals;

  /// `position(node)` [m].
  template <class Position>
  void place(const ConvexPiece& piece, const Position& position) {
    shape = piece.shape;
    corners.clear();
    for (const int node : piece.nodes) corners.push_back(position(node));
    find_normals();
  }
  /// The corner farthest along a direction.
  const Vec3& farthest(const Vec3& direction) const;

 private:
  void find_normals();
};

/// How far apart two convex pieces are along a direction (unit, from the first to the second), below 0: how deep they
/// lie in each other along it. [m]
struct Gap {
  Vec3 direction = Vec3::UnitX();
  double width = 0;
};

double gap_along(const Vec3& direction, const PlacedPiece& first, const PlacedPiece& second);

/// Of two pieces that lie in each other along a direction: the corner of one of them that is deepest in the other [m].
const Vec3& deepest_corner(const Vec3& direction, const PlacedPiece& first, const PlacedPiece& second);

/// The widest of these gaps, which is along a face's normal or across two edges (separating axis theorem; Gottschalk,
/// Lin, Manocha 1996), or any that is wider than `enough` [m]. Pieces that lie in each other need go no farther than
/// that to be apart. Shares nothing with the search for contacts, so that what that one misses is seen.
Gap widest_gap(const PlacedPiece& first, const PlacedPiece& second, double enough);

}  // namespace talus
