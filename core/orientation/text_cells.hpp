#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

/// A table as text, before anybody knows what its columns mean.
struct TextLine {
  int number = 0;                  ///< from 1, as an editor counts
  std::vector<std::string> cells;  ///< without blanks around them
};

struct TextCells {
  char separator = ',';  ///< ',', ';', a tab, or ' ' for any number of blanks
  std::vector<TextLine> lines;
};

/// Takes text from a file or from a spreadsheet apart: the separator is found from the lines that begin with a number
/// (tabs before semicolons before commas before blanks; a comma between two digits with blanks elsewhere is a decimal
/// comma). Blank lines and lines that begin with # or // are left out; "quoted" cells may hold separators; any ends of
/// lines and a byte order mark are fine.
TextCells cells_of(std::string_view text);

/// A number as people write it: with ° or "deg" behind it, a true minus sign, and a decimal comma unless `separator` is
/// the comma. Nothing when it is none.
std::optional<double> number_in_cell(std::string_view cell, char separator);

}  // namespace talus
