#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "orientation/attitude.hpp"

/// Tables of joints as surveys and spreadsheets have them.
namespace talus {

/// A joint that somebody measured.
struct MeasuredJoint {
  PlaneAttitude plane;
  std::string set;                      ///< name of its set; empty where the table says none
  std::optional<Vec3> at{};             ///< m, a point on it
  std::optional<double> spacing{};      ///< m, to the next one of its set
  std::optional<double> persistence{};  ///< m, length of its trace
  std::vector<Vec3> corners{};          ///< m, of the face it was seen as, in order; empty: nothing says where it ends
  bool operator==(const MeasuredJoint&) const = default;
};

/// What is wrong in a cell, or with a line where `column` is empty.
struct CellProblem {
  std::string column, problem, remedy;
};

/// One line of the text, with what it says.
struct JointLine {
  int number = 0;  ///< from 1
  std::vector<std::string> cells;
  std::optional<MeasuredJoint> joint;  ///< absent when there is a problem
  std::vector<CellProblem> problems;
};

/// A table as far as it could be read.
struct JointTable {
  std::vector<std::string> columns;   ///< what each column of the text was taken for: "dip", "set"; empty: left out
  std::vector<CellProblem> problems;  ///< of the table as a whole
  std::vector<std::string> notes;     ///< what was assumed, and which columns were left out
  std::vector<JointLine> lines;       ///< without the header

  bool sound() const;
  std::vector<MeasuredJoint> joints() const;  ///< of the lines without problems
};

/// Reads CSV, TSV, or text from a clipboard, with a header or without.
///
/// Columns are known by their names, whatever their case, spaces and units: dip; dip direction (or strike, by the
/// right-hand rule); set; x, y, z; spacing; persistence. Lengths in brackets as mm, cm or m. Others are left out.
/// A cell "45/120" is dip and dip direction. Without a header the columns are dip, dip direction, set (the first one
/// that is no number), x, y, z, spacing, persistence; where the first of two angles is above 90 somewhere and the
/// second never, they are dip direction and dip.
JointTable read_joint_table(std::string_view text);

/// The joints of a table without a fault. Throws InputError at the first problem, "line 3, column dip".
std::vector<MeasuredJoint> sound_joints(const JointTable& table);

/// CSV with a header that `read_joint_table` reads back digit for digit; columns that no joint has are left out.
std::string joint_table_text(std::span<const MeasuredJoint> joints);

}  // namespace talus
