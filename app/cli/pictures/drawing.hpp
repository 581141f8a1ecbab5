#pragma once

#include <CLI/App.hpp>

#include "options.hpp"
#include "pictures/side_by_side.hpp"

namespace talus::cli {

/// A picture of one frame of results, as `render` and the lines of a list of baselines describe it.
struct Drawing {
  std::vector<std::filesystem::path> results;
  FrameChoice choice;
  PictureSize size{1600, 1000};
  bool has_size = false;  ///< it was given
  Look look;
  bool over = false;  ///< the second results over the first
};

/// All options that say what a picture shows. `drawing` outlives the command.
void add_drawing(CLI::App& command, Drawing& drawing);

/// Throws InputError for results, frames or fields there are not.
SideBySide draw(const Drawing& drawing);

}  // namespace talus::cli
