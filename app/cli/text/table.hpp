#pragma once

#include <string>
#include <vector>

namespace talus::cli {

/// A table as text: numbers to the right, words to the left, two spaces between columns.
class Table {
 public:
  /// `alignment`: a letter a column, l or r.
  Table(std::vector<std::string> headings, std::string alignment);
  void add(std::vector<std::string> cells);
  std::string text() const;

 private:
  std::string alignment_;
  std::vector<std::vector<std::string>> rows_;
};

/// Characters of UTF-8 text.
std::size_t width_of(const std::string& text);
/// `text` with spaces after it, or before it, up to `width` characters.
std::string padded(const std::string& text, std::size_t width);
std::string padded_left(const std::string& text, std::size_t width);

/// The widest that text for a reader becomes.
inline constexpr std::size_t line_width = 100;
/// Words of `text`.
std::vector<std::string> words_of(const std::string& text);
/// Pieces with a space between, in lines of at most `width` characters where no piece is longer.
std::vector<std::string> wrapped(const std::vector<std::string>& pieces, std::size_t width);

/// `value` with `digits` significant digits.
std::string number(double value, int digits = 6);

}  // namespace talus::cli
