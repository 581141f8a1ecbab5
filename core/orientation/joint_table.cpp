#include "orientation/joint_table.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "model/number_text.hpp"
#include "orientation/joint_columns.hpp"

namespace talus {
namespace {

/// Reads the cells of one line.
class LineReader {
 public:
  LineReader(const TextLine& line, const JointColumns& columns, char separator)
      : columns_(columns), separator_(separator), read_{line.number, line.cells, std::nullopt, {}} {}

  JointLine read() {
    MeasuredJoint joint;
    joint.plane = plane();
    if (const auto cell = cell_of(JointColumn::set)) joint.set = *cell;
    joint.at = place();
    joint.spacing = length(JointColumn::spacing);
    joint.persistence = length(JointColumn::persistence);
    if (read_.problems.empty()) read_.joint = joint;
    return std::move(read_);
  }

 private:
  /// Column of that meaning; past the last one where there is none.
  std::size_t index_of(JointColumn kind) const {
    return static_cast<std::size_t>(std::ranges::find(columns_.kinds, kind) - columns_.kinds.begin());
  }

  const std::string* cell_of(JointColumn kind) const {
    const std::size_t index = index_of(kind);
    return index < columns_.kinds.size() && index < read_.cells.size() && !read_.cells[index].empty()
               ? &read_.cells[index]
               : nullptr;
  }

  void add(JointColumn kind, const std::string& problem, const std::string& remedy) {
    read_.problems.push_back({std::string(to_string(kind)), problem, remedy});
  }

  double angle(JointColumn kind, const std::string& text, double most) {
    const auto value = number_in_cell(text, separator_);
    const std::string range = "give degrees from 0 to " + number_text(most);
    if (!value)
      add(kind, "\"" + text + "\" is no number", range);
    else if (*value < 0 || *value > most)
      add(kind, text + " is out of range", range);
    return value.value_or(0);
  }

  double needed_angle(JointColumn kind, double most) {
    const std::string* cell = cell_of(kind);
    if (cell) return angle(kind, *cell, most);
    add(kind, "it is missing", "give degrees from 0 to " + number_text(most));
    return 0;
  }

  PlaneAttitude plane() {
    if (index_of(JointColumn::plane) < columns_.kinds.size()) {
      const std::string* cell = cell_of(JointColumn::plane);
      const std::size_t slash = cell ? cell->find('/') : std::string::npos;
      if (slash != std::string::npos)
        return upright({angle(JointColumn::dip, cell->substr(0, slash), 90),
                        angle(JointColumn::dip_direction, cell->substr(slash + 1), 360)});
      add(JointColumn::plane, cell ? "\"" + *cell + "\" is no plane" : "it is missing", "write it as in 45/120");
      return {};
    }
    const double dip = needed_angle(JointColumn::dip, 90);
    if (index_of(JointColumn::strike) < columns_.kinds.size())
      return upright({dip, dip_direction_of_strike(needed_angle(JointColumn::strike, 360))});
    return upright({dip, needed_angle(JointColumn::dip_direction, 360)});
  }

  std::optional<double> number(JointColumn kind) {
    const std::string* cell = cell_of(kind);
    if (!cell) return std::nullopt;
    const auto value = number_in_cell(*cell, separator_);
    if (!value) {
      add(kind, "\"" + *cell + "\" is no number", "give metres, or leave it empty");
      return std::nullopt;
    }
    return *value * columns_.factors[index_of(kind)];
  }

  std::optional<double> length(JointColumn kind) {
    const auto value = number(kind);
    if (value && !(*value > 0)) add(kind, *cell_of(kind) + " is not positive", "give metres, or leave it empty");
    return value;
  }

  std::optional<Vec3> place() {
    const std::size_t before = read_.problems.size();
    const auto x = number(JointColumn::x), y = number(JointColumn::y), z = number(JointColumn::z);
    if (x && y && z) return Vec3(*x, *y, *z);
    if ((x || y || z) && read_.problems.size() == before)
      add(x ? (y ? JointColumn::z : JointColumn::y) : JointColumn::x, "it is missing",
          "give all of x, y and z, or none");
    return std::nullopt;
  }

  const JointColumns& columns_;
  char separator_;
  JointLine read_;
};

std::string place_of(const CellProblem& problem, int line) {
  const std::string column = problem.column.empty() ? "" : "column " + problem.column;
  if (line == 0) return column.empty() ? "table" : column;
  return "line " + std::to_string(line) + (column.empty() ? "" : ", " + column);
}

/// As CSV wants a word that holds commas or quotes, or would be taken for a comment.
std::string csv_word(const std::string& word) {
  if (word.find_first_of(",;\"\t#/ ") == std::string::npos) return word;
  std::string quoted = "\"";
  for (const char c : word) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

bool JointTable::sound() const {
  return problems.empty() && std::ranges::all_of(lines, [](const JointLine& line) { return line.joint.has_value(); });
}

std::vector<MeasuredJoint> JointTable::joints() const {
  std::vector<MeasuredJoint> found;
  for (const JointLine& line : lines)
    if (line.joint) found.push_back(*line.joint);
  return found;
}

JointTable read_joint_table(std::string_view text) {
  const TextCells cells = cells_of(text);
  const JointColumns columns = joint_columns(cells);
  JointTable table;
  for (const JointColumn kind : columns.kinds) table.columns.emplace_back(to_string(kind));
  table.problems = columns.problems;
  table.notes = columns.notes;
  for (std::size_t i = columns.header ? 1 : 0; i < cells.lines.size(); ++i) {
    const TextLine& line = cells.lines[i];
    if (table.problems.empty())
      table.lines.push_back(LineReader(line, columns, cells.separator).read());
    else  // nobody knows what the cells mean
      table.lines.push_back({line.number, line.cells, std::nullopt, {}});
  }
  if (table.lines.empty() && table.problems.empty())
    table.problems.push_back({"", "there is no line below the header", "give a dip and a dip direction a line"});
  return table;
}

std::vector<MeasuredJoint> sound_joints(const JointTable& table) {
  const auto refuse = [](const CellProblem& problem, int line) {
    throw InputError(place_of(problem, line), problem.problem, problem.remedy);
  };
  for (const CellProblem& problem : table.problems) refuse(problem, 0);
  for (const JointLine& line : table.lines)
    for (const CellProblem& problem : line.problems) refuse(problem, line.number);
  return table.joints();
}

std::string joint_table_text(std::span<const MeasuredJoint> joints) {
  const auto any = [&](auto has) { return std::ranges::any_of(joints, has); };
  const bool sets = any([](const MeasuredJoint& joint) { return !joint.set.empty(); });
  const bool places = any([](const MeasuredJoint& joint) { return joint.at.has_value(); });
  const bool spacings = any([](const MeasuredJoint& joint) { return joint.spacing.has_value(); });
  const bool lengths = any([](const MeasuredJoint& joint) { return joint.persistence.has_value(); });
  const auto number = [](const std::optional<double>& value) { return value ? number_text(*value) : std::string(); };

  std::string text = "dip [°],dip direction [°]";
  if (sets) text += ",set";
  if (places) text += ",x [m],y [m],z [m]";
  if (spacings) text += ",spacing [m]";
  if (lengths) text += ",persistence [m]";
  text += '\n';
  for (const MeasuredJoint& joint : joints) {
    text += number_text(joint.plane.dip) + ',' + number_text(joint.plane.dip_direction);
    if (sets) text += ',' + csv_word(joint.set);
    if (places)
      for (int i = 0; i < 3; ++i) text += ',' + (joint.at ? number_text((*joint.at)[i]) : std::string());
    if (spacings) text += ',' + number(joint.spacing);
    if (lengths) text += ',' + number(joint.persistence);
    text += '\n';
  }
  return text;
}

}  // namespace talus
