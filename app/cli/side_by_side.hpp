#pragma once

#include <filesystem>
#include <vector>

#include "options.hpp"
#include "render/paint/image.hpp"

namespace talus::cli {

/// A frame of some results, and where and when it was drawn.
struct DrawnFrame {
  std::filesystem::path results;
  int frame = 0;
  double time = 0;  ///< s
};

struct SideBySide {
  Image picture;
  std::vector<DrawnFrame> frames;  ///< from left to right
};

/// Draws one frame of each of the results in a picture of that size: several of them from the same place, with one
/// range of colours, each under the name of its folder. Throws InputError for results or frames there are not, and for
/// more than four.
SideBySide draw_side_by_side(const std::vector<std::filesystem::path>& results, const FrameChoice& choice,
                             const Look& look, const PictureSize& size);

}  // namespace talus::cli
