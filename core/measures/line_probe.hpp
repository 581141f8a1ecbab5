#pragma once

#include <string>
#include <vector>

#include "bodies/block_pose.hpp"
#include "results/field.hpp"

namespace talus {

/// A field along a straight line through the blocks where they are in a frame: pieces of it, one for each tetrahedron
/// that it passes, in order. A field of nodes is linear in a piece, one of tetrahedra or blocks the same.
struct LineProbe {
  struct Piece {
    int block = -1;
    double begin = 0, end = 0;                    ///< m from the line's start
    double value_at_begin = 0, value_at_end = 0;  ///< SI
  };
  std::vector<Piece> pieces;

  /// The pieces as a curve: two points each, and one of no value where the line leaves the rock.
  struct Curve {
    std::vector<double> along, values;  ///< m, SI
  };
  Curve curve() const;
};

/// Throws InputError where both ends are one point, and for a field of joints.
LineProbe probe_line(const BlockSystem& system, const Frame& frame, const Field& field, const Vec3& from,
                     const Vec3& to);

/// "distance [m],x [m],y [m],z [m],block,stress.zz [Pa]", a line for each end of each piece.
std::string probe_csv(const LineProbe& probe, const BlockSystem& system, const Field& field, const Vec3& from,
                      const Vec3& to);

}  // namespace talus
