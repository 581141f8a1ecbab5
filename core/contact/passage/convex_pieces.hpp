#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "bodies/body_set.hpp"
#include "mesh/surface.hpp"

namespace talus {

/// How the corners of a convex polyhedron are joined. Numbers are those of its corners.
struct ConvexShape {
  struct Edge {
    std::array<int, 2> corners;
    std::array<int, 2> faces;  ///< that it joins
  };
  std::vector<std::array<int, 3>> faces;  ///< three corners of each, counter-clockwise as seen from outside
  std::vector<Edge> edges;                ///< between faces of different planes
};

/// A convex part of a body. A convex body has one, itself; any other one for each of its tetrahedra.
struct ConvexPiece {
  const ConvexShape* shape;
  std::span<const int> nodes;  ///< of its corners, into NodeSet
};

/// The convex pieces of all blocks, made once from their undeformed meshes. Blocks that deform or turn keep them: a
/// tetrahedron stays one, and so does a convex rigid or affine block. A convex block that is meshed to deform is taken
/// apart into its tetrahedra.
class ConvexPieces {
 public:
  /// `surfaces`: one a block.
  ConvexPieces(const BlockSystem& system, const BodySet& bodies, std::span<const Surface> surfaces);

  std::size_t bodies() const { return thickness_.size(); }
  int count(int body) const { return begin_[body + 1] - begin_[body]; }
  /// Of the pieces of a body, `number` among them.
  ConvexPiece piece(int body, int number) const;
  /// 2 V / A of a body [m]: how thick a plate is, two thirds of half a cube's side.
  double thickness(int body) const { return thickness_[body]; }
  /// The mesh size of two bodies, that of the finer [m]; a body that was built fixed does not count. Infinite for two.
  double size(int body_a, int body_b) const { return std::min(sizes_[body_a], sizes_[body_b]); }

 private:
  std::vector<std::unique_ptr<ConvexShape>> whole_;  // a body: its shape, none where it is taken apart
  std::vector<int> begin_ = {0}, nodes_begin_ = {0}, nodes_;
  std::vector<double> thickness_, sizes_;
};

}  // namespace talus
