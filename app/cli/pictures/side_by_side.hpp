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

/// `over`: the second results are drawn over the first.
void add_over(CLI::App& command, bool& over);

/// Throws InputError for more than four, and for others than two where one is drawn over the other.
void need_few(const std::vector<std::filesystem::path>& results, bool over);

/// Draws one frame of each of the results in a picture of that size: several of them from the same place, with one
/// range of colours, each under the name of its folder; or, `over` each other,
/// the second ones as outlines over the first. Throws InputError for results or frames there are not, and for
/// more than four.
SideBySide draw_side_by_side(const std::vector<std::filesystem::path>& results, const FrameChoice& choice,
                             const Look& look, bool over, const PictureSize& size);

}  // namespace talus::cli
