#pragma once

#include <CLI/App.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "values/chart_files.hpp"

namespace talus::cli {

/// A line through the rock, and what is looked at along it.
struct LineChoice {
  std::string ends;   ///< "x,y,z,x,y,z", m; empty: no line
  std::string field;  ///< empty: displacement
  FrameChoice frame;
};

/// Adds `--line`, `--field`, `--time` and `--frame`; a line is plotted in place of what `monitor` and `block` choose.
void add_line_choice(CLI::App& command, LineChoice& choice);

/// Writes the chart of a field along the line, or its table where `files.out` ends in .csv; returns the files. Throws
/// InputError for a line, a field or a frame there is not, and where nothing can be written.
std::vector<std::string> write_line(const LineChoice& choice, const ResultReader& results, const ChartFiles& files);

}  // namespace talus::cli
