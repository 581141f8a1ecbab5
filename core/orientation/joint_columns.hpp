#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "orientation/joint_table.hpp"
#include "orientation/text_cells.hpp"

namespace talus {

/// What a column of a table of joints can hold; `plane` is "45/120" in one cell.
enum class JointColumn { none, plane, dip, dip_direction, strike, set, x, y, z, spacing, persistence };

/// As messages and headers say it: "dip direction".
std::string_view to_string(JointColumn column);

/// What the columns of a table are.
struct JointColumns {
  std::vector<JointColumn> kinds;
  std::vector<double> factors;  ///< to metres, of lengths
  bool header = false;          ///< the first line names the columns
  std::vector<CellProblem> problems;
  std::vector<std::string> notes;
};

JointColumns joint_columns(const TextCells& table);

}  // namespace talus
