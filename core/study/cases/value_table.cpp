#include "study/cases/value_table.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "model/number_text.hpp"
#include "orientation/text_cells.hpp"

namespace talus {

namespace {

constexpr const char* name_column = "case";

/// What a cell says, as JSON: what is neither number nor JSON is a text.
std::string json_of_cell(const std::string& cell, char separator) {
  if (cell.empty()) return {};
  if (const auto number = number_in_cell(cell, separator)) return number_text(*number);
  const bool may_be_json = cell.front() == '[' || cell == "true" || cell == "false" || cell == "null";
  if (may_be_json && nlohmann::json::accept(cell)) return cell;
  return nlohmann::json(cell).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

bool is_utf8(std::string_view text) {
  try {
    return !nlohmann::json(text).dump().empty();
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

struct Header {
  std::optional<std::size_t> name;  ///< which column has the names of cases
  std::vector<std::string> cells;
};

Header header_of(const TextLine& line) {
  Header header{{}, line.cells};
  std::set<std::string> seen;
  for (std::size_t i = 0; i < line.cells.size(); ++i) {
    const std::string& cell = line.cells[i];
    const std::string place = cell_place(line.number, cell.empty() ? std::to_string(i + 1) : cell);
    if (cell == name_column) header.name = i;
    if (cell != name_column && !cell.starts_with('/'))
      throw InputError(place, "is no place in a project",
                       "head columns by places like /joints/J1/friction_angle, or one by case");
    if (!seen.insert(cell).second) throw InputError(place, "is there twice", "keep one of them");
  }
  if (header.cells.size() == (header.name ? 1u : 0u))
    throw InputError("line " + std::to_string(line.number), "the table changes nothing",
                     "give a column that is headed by a place like /joints/J1/friction_angle");
  return header;
}

ValueTable::Row row_of(const TextLine& line, const Header& header, std::size_t number, char separator) {
  ValueTable::Row row{line.number, std::to_string(number), {}};
  if (line.cells.size() > header.cells.size())
    throw InputError(
        "line " + std::to_string(line.number),
        "has " + std::to_string(line.cells.size()) + " cells, the header " + std::to_string(header.cells.size()),
        "take out what is too much, or put quotes around texts with commas");
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    const std::string cell = i < line.cells.size() ? line.cells[i] : std::string();
    if (i != header.name)
      row.values.push_back(json_of_cell(cell, separator));
    else if (!cell.empty())
      row.name = cell;
  }
  return row;
}

}  // namespace

std::string value_as_cell(const std::string& json) {
  return json.starts_with('"') ? nlohmann::json::parse(json).get<std::string>() : json;
}

std::string cell_place(int line, const std::string& column) {
  return "line " + std::to_string(line) + ", column " + column;
}

ValueTable read_value_table(std::string_view text) {
  if (!is_utf8(text)) throw InputError("the table", "is no UTF-8 text", "save it as UTF-8");
  const TextCells cells = cells_of(text);
  if (cells.lines.size() < 2)
    throw InputError("the table", "has no case",
                     "give a header, like case,/joints/J1/friction_angle, and a line a case");
  const Header header = header_of(cells.lines.front());
  ValueTable table;
  for (std::size_t i = 0; i < header.cells.size(); ++i)
    if (i != header.name) table.columns.push_back(header.cells[i]);
  std::set<std::string> names;
  for (std::size_t i = 1; i < cells.lines.size(); ++i) {
    table.rows.push_back(row_of(cells.lines[i], header, i, cells.separator));
    if (!names.insert(table.rows.back().name).second)
      throw InputError(cell_place(cells.lines[i].number, name_column),
                       "another case is called '" + table.rows.back().name + "'", "give each case a name of its own");
  }
  return table;
}

}  // namespace talus
