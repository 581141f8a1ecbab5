#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace talus {

/// Values for places of a project, a row a case.
struct ValueTable {
  struct Row {
    int line = 0;                     ///< of the text, from 1
    std::string name;                 ///< of the column `case`, else the number of the row, from 1
    std::vector<std::string> values;  ///< a column, as JSON; empty: the project's own
  };
  std::vector<std::string> columns;  ///< JSON pointers, "/joints/J1/friction_angle"
  std::vector<Row> rows;
};

/// Reads CSV (or with semicolons or tabs) whose header names places of the project, and perhaps `case`. A cell is a
/// number as people write it, true, false, null, a list, or a text. Throws InputError, "line 3, column /cuts/0/dip".
ValueTable read_value_table(std::string_view text);

/// A value as a table has it: a text without its quotes.
std::string value_as_cell(const std::string& json);

/// Where a cell stands: "line 3, column /cuts/0/dip".
std::string cell_place(int line, const std::string& column);

}  // namespace talus
