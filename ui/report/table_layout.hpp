#pragma once

#include <vector>

namespace talus::report {

/// What a column of a table asks for.
struct ColumnNeed {
  double least = 0;    ///< width of its longest word
  double natural = 0;  ///< width of its longest cell, on one line
};

/// Widths of columns that together take at most `room`: each as wide as it asks for where there is room; else those
/// that can be broken into lines give, each in proportion to what it has beyond its longest word.
std::vector<double> column_widths(const std::vector<ColumnNeed>& needs, double room);

}  // namespace talus::report
