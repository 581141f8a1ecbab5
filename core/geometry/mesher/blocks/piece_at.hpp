#pragma once

#include <span>
#include <string>

#include "geometry/mesher/blocks/block_cutter.hpp"

namespace talus {

/// A point of the project that stands for a piece.
struct PiecePoint {
  std::string title;    ///< "block override 2 (wedge)"
  const char* key;      ///< of the point: "at"
  Vec3 where{0, 0, 0};  ///< relative to the model's origin
};

/// Index of the one piece that holds the point; `names` are those of the pieces. Throws InputError for a point in no
/// piece and for one on the border of two.
std::size_t piece_at(const PiecePoint& point, const CutModel& cut, std::span<const std::string> names);

}  // namespace talus
