#include "orientation/joint_columns.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <regex>

namespace talus {
namespace {

/// A heading taken apart: "Dip Direction [°]" is "dipdirection" and "°".
struct Heading {
  std::string name, unit;
};

Heading heading_of(const std::string& cell) {
  static const std::regex with_unit(R"(([^\(\[]*)[\(\[]([^\)\]]*)[\)\]]?.*)");
  std::smatch part;
  Heading heading{cell, ""};
  if (std::regex_match(cell, part, with_unit)) heading = {part[1], part[2]};
  std::string plain;
  for (const unsigned char c : heading.name)
    if (std::isalpha(c) || c == '/') plain += static_cast<char>(std::tolower(c));
  return {plain, heading.unit};
}

JointColumn column_named(const std::string& name) {
  using enum JointColumn;
  static const std::map<std::string, JointColumn> names{{"plane", plane},
                                                        {"attitude", plane},
                                                        {"orientation", plane},
                                                        {"dip/dipdirection", plane},
                                                        {"dip/dipdir", plane},
                                                        {"dip/dir", plane},
                                                        {"dip", dip},
                                                        {"dipangle", dip},
                                                        {"dipdeg", dip},
                                                        {"dipdirection", dip_direction},
                                                        {"dipdir", dip_direction},
                                                        {"dipdirn", dip_direction},
                                                        {"dipdirectiondeg", dip_direction},
                                                        {"dipdirdeg", dip_direction},
                                                        {"ddir", dip_direction},
                                                        {"dd", dip_direction},
                                                        {"dipazimuth", dip_direction},
                                                        {"strike", strike},
                                                        {"strikerhr", strike},
                                                        {"strikeright", strike},
                                                        {"set", set},
                                                        {"jointset", set},
                                                        {"setid", set},
                                                        {"setname", set},
                                                        {"family", set},
                                                        {"joint", set},
                                                        {"x", x},
                                                        {"east", x},
                                                        {"easting", x},
                                                        {"y", y},
                                                        {"north", y},
                                                        {"northing", y},
                                                        {"z", z},
                                                        {"elevation", z},
                                                        {"elev", z},
                                                        {"height", z},
                                                        {"spacing", spacing},
                                                        {"meanspacing", spacing},
                                                        {"persistence", persistence},
                                                        {"trace", persistence},
                                                        {"tracelength", persistence},
                                                        {"length", persistence}};
  const auto found = names.find(name);
  return found == names.end() ? none : found->second;
}

bool is_angle(JointColumn column) {
  return column == JointColumn::dip || column == JointColumn::dip_direction || column == JointColumn::strike;
}

/// What a unit makes of a number; nothing when it is unknown.
std::optional<double> factor_of(JointColumn column, const std::string& unit) {
  if (unit.empty() || column == JointColumn::none || column == JointColumn::set || column == JointColumn::plane)
    return 1;
  if (is_angle(column)) {
    for (const char* degree : {"\xC2\xB0", "\xB0", "deg", "degree", "degrees"})
      if (unit == degree) return 1;
    return std::nullopt;
  }
  if (unit == "m") return 1;
  if (unit == "cm") return 0.01;
  if (unit == "mm") return 0.001;
  return std::nullopt;
}

bool has(const JointColumns& columns, JointColumn kind) { return std::ranges::count(columns.kinds, kind) > 0; }

void check(JointColumns& columns) {
  using enum JointColumn;
  const bool direction = has(columns, dip_direction) || has(columns, strike);
  if (!has(columns, plane) && !(has(columns, dip) && direction))
    columns.problems.push_back(
        {"", "no columns of dip and dip direction were found",
         "name two columns \"dip\" and \"dip direction\" (or \"strike\"), or leave the header out"});
  for (const JointColumn kind : {plane, dip, dip_direction, strike, set, x, y, z, spacing, persistence})
    if (std::ranges::count(columns.kinds, kind) > 1)
      columns.problems.push_back(
          {std::string(to_string(kind)), "there are two columns of that meaning", "leave one of them out"});
  if (has(columns, dip_direction) && has(columns, strike))
    columns.problems.push_back({"strike", "there are columns of dip direction and of strike", "leave one of them out"});
  const int places =
      static_cast<int>(has(columns, x)) + static_cast<int>(has(columns, y)) + static_cast<int>(has(columns, z));
  if (places == 1 || places == 2)
    columns.problems.push_back({"x", "a place needs all of x, y and z", "add the missing column, or leave them out"});
}

JointColumns named_columns(const TextLine& line) {
  JointColumns columns;
  columns.header = true;
  for (const std::string& cell : line.cells) {
    const Heading heading = heading_of(cell);
    const JointColumn kind = column_named(heading.name);
    columns.kinds.push_back(kind);
    if (kind == JointColumn::none && !cell.empty()) columns.notes.push_back("column \"" + cell + "\" is left out");
    const std::optional<double> factor = factor_of(kind, heading.unit);
    columns.factors.push_back(factor.value_or(1));
    if (!factor)
      columns.problems.push_back({std::string(to_string(kind)), "the unit \"" + heading.unit + "\" is not known here",
                                  is_angle(kind) ? "give angles in degrees" : "give lengths in m, cm or mm"});
  }
  return columns;
}

bool is_plane_cell(const std::string& cell) {
  static const std::regex form(R"([^/]*\d[^/]*/[^/]*\d[^/]*)");
  return std::regex_match(cell, form);
}

/// Whether the first of two columns of angles holds dip directions: above 90 somewhere, while the second never is.
bool direction_first(const TextCells& table, std::size_t first, std::size_t second) {
  bool above = false;
  for (const TextLine& line : table.lines) {
    if (line.cells.size() <= second) continue;
    const auto a = number_in_cell(line.cells[first], table.separator);
    const auto b = number_in_cell(line.cells[second], table.separator);
    if (b.value_or(0) > 90) return false;
    above = above || a.value_or(0) > 90;
  }
  return above;
}

JointColumns columns_by_order(const TextCells& table) {
  using enum JointColumn;
  JointColumns columns;
  std::vector<JointColumn> numbers{dip, dip_direction, x, y, z, spacing, persistence};
  std::vector<std::size_t> angles;
  const std::vector<std::string>& cells = table.lines.front().cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    JointColumn kind = none;
    if (is_plane_cell(cells[i]) && !has(columns, plane) && angles.empty()) {
      kind = plane;
      numbers.erase(numbers.begin(), numbers.begin() + 2);
    } else if (number_in_cell(cells[i], table.separator) || (cells[i].empty() && has(columns, set))) {
      if (!numbers.empty()) {
        kind = numbers.front();
        numbers.erase(numbers.begin());
      }
      if (is_angle(kind)) angles.push_back(i);
    } else if (!cells[i].empty() && !has(columns, set)) {
      kind = set;
    }
    columns.kinds.push_back(kind);
  }
  columns.factors.assign(cells.size(), 1);
  if (angles.size() == 2 && direction_first(table, angles[0], angles[1])) {
    std::swap(columns.kinds[angles[0]], columns.kinds[angles[1]]);
    columns.notes.push_back("the first column goes above 90 and the second does not: taken for dip direction and dip");
  }
  return columns;
}

}  // namespace

std::string_view to_string(JointColumn column) {
  switch (column) {
    case JointColumn::plane:
      return "dip/dip direction";
    case JointColumn::dip:
      return "dip";
    case JointColumn::dip_direction:
      return "dip direction";
    case JointColumn::strike:
      return "strike";
    case JointColumn::set:
      return "set";
    case JointColumn::x:
      return "x";
    case JointColumn::y:
      return "y";
    case JointColumn::z:
      return "z";
    case JointColumn::spacing:
      return "spacing";
    case JointColumn::persistence:
      return "persistence";
    case JointColumn::none:
      break;
  }
  return "";
}

JointColumns joint_columns(const TextCells& table) {
  if (table.lines.empty()) {
    JointColumns columns;
    columns.problems.push_back({"", "there is no line with a joint", "give a dip and a dip direction a line"});
    return columns;
  }
  const auto tells_figures = [&](const std::string& cell) {
    return number_in_cell(cell, table.separator) || is_plane_cell(cell);
  };
  const TextLine& first = table.lines.front();
  JointColumns columns =
      std::ranges::any_of(first.cells, tells_figures) ? columns_by_order(table) : named_columns(first);
  check(columns);
  return columns;
}

}  // namespace talus
