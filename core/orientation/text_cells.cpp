#include "orientation/text_cells.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <regex>

namespace talus {
namespace {

std::string without_blanks_around(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

struct RawLine {
  int number = 0;
  std::string text;
};

std::vector<RawLine> lines_of(std::string_view given) {
  std::string text(given);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  replace_all(text, "\r\n", "\n");
  std::ranges::replace(text, '\r', '\n');
  std::vector<RawLine> lines;
  int number = 0;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string line = text.substr(start, end - start), bare = without_blanks_around(line);
    ++number;
    if (!bare.empty() && !bare.starts_with('#') && !bare.starts_with("//")) lines.push_back({number, line});
    start = end + 1;
  }
  return lines;
}

char separator_in(const std::string& line) {
  // A number, blanks, a number, where either may have a decimal comma: the comma separates nothing.
  static const std::regex decimal_commas(R"(\s*[-+]?\d+(,\d+)?\S?\s+[-+]?\d+(,\d+)?\S?(\s.*)?)");
  if (line.find('\t') != std::string::npos) return '\t';
  if (line.find(';') != std::string::npos) return ';';
  if (line.find(',') == std::string::npos || std::regex_match(line, decimal_commas)) return ' ';
  return ',';
}

/// What most lines with figures say; of a table without any, what its first line says.
char separator_of(const std::vector<RawLine>& lines) {
  constexpr std::array candidates{'\t', ';', ',', ' '};
  std::array<int, 4> votes{};
  for (const RawLine& line : lines)
    if (std::ranges::any_of(line.text, [](unsigned char c) { return std::isdigit(c) != 0; }) &&
        without_blanks_around(line.text).find_first_of("\t;, ") != std::string::npos)  // a lone number says nothing
      ++votes[static_cast<std::size_t>(std::ranges::find(candidates, separator_in(line.text)) - candidates.begin())];
  const auto most = std::ranges::max_element(votes);
  if (*most == 0) return lines.empty() ? ',' : separator_in(lines.front().text);
  return candidates[static_cast<std::size_t>(most - votes.begin())];
}

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool blank = c == ' ' || c == '\t';
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && separator == ' ' && blank) {
      if (!cells.back().empty()) cells.emplace_back();
    } else if (!quoted && separator != ' ' && c == separator) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  if (separator == ' ' && cells.back().empty()) cells.pop_back();
  for (std::string& cell : cells) cell = without_blanks_around(cell);
  return cells;
}

}  // namespace

TextCells cells_of(std::string_view text) {
  const std::vector<RawLine> lines = lines_of(text);
  TextCells table{separator_of(lines), {}};
  for (const RawLine& line : lines) {
    TextLine split_line{line.number, split(line.text, table.separator)};
    const bool blank = std::ranges::all_of(split_line.cells, [](const std::string& cell) { return cell.empty(); });
    if (!blank) table.lines.push_back(std::move(split_line));  // a spreadsheet's empty row is nothing but separators
  }
  return table;
}

std::optional<double> number_in_cell(std::string_view cell, char separator) {
  std::string text(cell);
  // Degree signs: °, º and ˚ in UTF-8, ° in Latin-1; a true minus; the spaces that spreadsheets put between digits.
  for (const char* sign : {"\xC2\xB0", "\xC2\xBA", "\xCB\x9A", "\xB0", "degrees", "deg", "\xC2\xA0", "\xE2\x80\xAF"})
    replace_all(text, sign, "");
  replace_all(text, "\xE2\x88\x92", "-");
  text = without_blanks_around(text);
  if (separator != ',' && std::ranges::count(text, ',') == 1 && text.find('.') == std::string::npos)
    replace_all(text, ",", ".");
  if (text.starts_with('+')) text.erase(0, 1);
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace talus
