#include "text/table.hpp"

#include <algorithm>

#include "model/number_text.hpp"

namespace talus::cli {

namespace {

std::string without_trailing_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string gap(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, width_of(text)), ' ');
}

}  // namespace

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width) { return text + gap(text, width); }

std::string padded_left(const std::string& text, std::size_t width) { return gap(text, width) + text; }

Table::Table(std::vector<std::string> headings, std::string alignment) : alignment_(std::move(alignment)) {
  rows_.push_back(std::move(headings));
}

void Table::add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

std::string Table::text() const {
  std::vector<std::size_t> widths(alignment_.size(), 0);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line +=
          (i == 0 ? "" : "  ") + (alignment_[i] == 'r' ? padded_left(row[i], widths[i]) : padded(row[i], widths[i]));
    text += without_trailing_spaces(line) + '\n';
  }
  return text;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ' ')
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

std::vector<std::string> wrapped(const std::vector<std::string>& pieces, std::size_t width) {
  std::vector<std::string> lines(1);
  for (const std::string& piece : pieces) {
    if (!lines.back().empty() && width_of(lines.back()) + 1 + width_of(piece) > width) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + piece;
  }
  return lines;
}

std::string number(double value, int digits) { return significant(value, digits); }

}  // namespace talus::cli
