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

/// `value` with `digits` significant digits.
std::string number(double value, int digits = 6);

}  // namespace talus::cli
