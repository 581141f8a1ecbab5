#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pictures/drawing.hpp"

namespace talus::cli {

/// A picture that was right, and how it is drawn.
struct Baseline {
  std::string name;            ///< as the list has it: "slope.png"
  std::filesystem::path file;  ///< in the list's folder
  std::string line;            ///< where the list says so: "baselines/baselines.txt: line 3"
  Drawing drawing;
};

/// Those of the list `baselines.txt` in a folder: a line each, with the picture's name, the results that it is drawn of
/// and options of `render`. Paths are relative to the folder; what stands behind # says nothing. Throws InputError with
/// the line that is wrong, where there is no list, and where it names no picture.
std::vector<Baseline> read_baselines(const std::filesystem::path& folder);

}  // namespace talus::cli
