#pragma once

#include "render/paint/image.hpp"

namespace talus {

/// A square of pixels; x to the right and y down from the picture's left upper corner.
struct PictureTile {
  int left = 0, top = 0, width = 0, height = 0;
};

/// How alike two pictures of one size are to the eye, tile by tile.
struct PictureDifference {
  double similarity = 1;  ///< of the worst tile: 1 equal, 0 nothing in common
  PictureTile worst;
  PictureTile region;  ///< around all tiles that are less alike than the threshold; empty where none is
  int tiles = 0, differing = 0;
};

/// What two pictures of the same scene have at least in their worst tile, however their edges were smoothed.
constexpr double alike_enough = 0.75;

/// Compares tiles of 16 × 16 pixels, each half over its neighbours, by their structural similarity; a tile differs
/// where that is below `threshold`. The worst one decides: a share of the picture would let a legend go, which is
/// small. Throws std::invalid_argument where the sizes differ.
PictureDifference compare_pictures(const Image& expected, const Image& actual, double threshold = alike_enough);

/// Both pictures and, beside them, the actual one in pale grey with what differs in red and a frame around the region.
Image difference_picture(const Image& expected, const Image& actual, double threshold = alike_enough);

}  // namespace talus
