#include "verification/markdown_table.hpp"

#include <algorithm>
#include <sstream>

namespace talus {

namespace {

/// A cell that does not end the table's row.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

constexpr std::ptrdiff_t line_width = 120;

/// Characters of UTF-8 text.
std::ptrdiff_t width_of(const std::string& text) {
  return std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

/// Whether a line that begins with it is an item of a list.
bool begins_an_item(const std::string& word) { return word == "+" || word == "-" || word == "*"; }

}  // namespace

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& text : cells) row += ' ' + cell(text) + " |";
  return row + '\n';
}

std::string markdown_heading(const std::vector<std::string>& columns, const std::string& alignment) {
  std::string rule = "|";
  for (const char letter : alignment) rule += letter == 'r' ? "--:|" : "---|";
  return markdown_row(columns) + rule + '\n';
}

std::string markdown_paragraph(const std::string& text, const std::string& indent) {
  std::istringstream words(text);
  std::string lines, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && width_of(line) + 1 + width_of(word) > line_width && !begins_an_item(word)) {
      lines += line + '\n';
      line = indent + word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
  }
  return lines + line + '\n';
}

}  // namespace talus
