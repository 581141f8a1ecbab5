#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "options.hpp"
#include "render/charts/charts.hpp"

namespace talus::cli {

struct Chart {
  std::string name;  ///< of its file, where it has one of its own
  HistoryPlot plot;
};

/// In rows, as on a sheet.
using Charts = std::vector<std::vector<Chart>>;

/// Where charts go, and how they look.
struct ChartFiles {
  std::filesystem::path out;
  PictureSize size{1600, 1000};
  Theme theme = Theme::light;
};

/// A sheet of all where `out` ends as one (sheet.hpp), else a PNG of each in the folder `out`, which is made. Returns
/// the files. Throws InputError where they cannot be written.
std::vector<std::string> write_charts(const ChartFiles& files, const Charts& charts, const std::string& title);

}  // namespace talus::cli
