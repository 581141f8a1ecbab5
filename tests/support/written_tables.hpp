#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

extern "C" char* openblas_get_corename();

/// The tables of docs/tables, held against what the program writes now.
namespace talus::test {

/// Rounding depends on the kernels that OpenBLAS chooses for a processor. The tables are written with those for
/// Haswell, which ctest asks for, too; with others their figures cannot be compared.
inline bool has_arithmetic_of_tables() { return std::string(openblas_get_corename()) == "Haswell"; }

/// What writes a table anew.
inline std::string how_to_mend(const std::string& options, const std::string& page) {
  const std::string file = "docs/tables/" + page;
  return file + " is stale: OPENBLAS_CORETYPE=Haswell talus-cli verify " + options + " --markdown " + file;
}

/// A number as it is written: its value and the unit of its last digit. Only those with a point or an exponent are
/// rounded; others are names and counts.
struct WrittenNumber {
  double value = 0, last_digit = 1;
};

inline WrittenNumber written_number(const std::string& text) {
  const std::size_t exponent = text.find('e'), point = text.find('.');
  const std::string digits = text.substr(0, exponent);
  const double decimals = point == std::string::npos ? 0 : static_cast<double>(digits.size() - point - 1);
  const double power = exponent == std::string::npos ? 0 : std::stod(text.substr(exponent + 1));
  return {std::stod(text), std::pow(10.0, power - decimals)};
}

/// Rounding noise: figures below it may be anything.
inline constexpr double noise = 1e-8;

/// Whether two lines say the same: all words and counts, and rounded numbers up to one in their last digit, which
/// another version of the C library may turn.
inline bool same_line(const std::string& a, const std::string& b) {
  static const std::regex rounded(R"(\d+\.\d*(e[-+]?\d+)?|\d+e[-+]?\d+)");
  std::sregex_token_iterator words_a(a.begin(), a.end(), rounded, -1), words_b(b.begin(), b.end(), rounded, -1), end;
  if (!std::equal(words_a, end, words_b, end)) return false;
  std::sregex_iterator one(a.begin(), a.end(), rounded), other(b.begin(), b.end(), rounded), none;
  for (; one != none && other != none; ++one, ++other) {
    const WrittenNumber x = written_number(one->str()), y = written_number(other->str());
    if (x.value < noise && y.value < noise) continue;
    if (std::abs(x.value - y.value) > 1.01 * std::max(x.last_digit, y.last_digit)) return false;
  }
  return one == none && other == none;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The first line that is not the same, written and as it would be now; empty: all are.
inline std::string difference(const std::string& written, const std::string& now) {
  const std::vector<std::string> a = lines_of(written), b = lines_of(now);
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const std::string was = i < a.size() ? a[i] : "nothing", is = i < b.size() ? b[i] : "nothing";
    if (was != is && !same_line(was, is)) return "written:\n  " + was + "\nnow:\n  " + is + '\n';
  }
  return {};
}

/// A page of docs/tables.
class WrittenPage {
 public:
  explicit WrittenPage(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(std::filesystem::path(TALUS_SOURCE_DIR) / "docs/tables" / name).rdbuf();
    text_ = text.str();
  }

  /// The row of a table whose first cell that is; empty: there is none.
  std::string row(const std::string& first_cell) const {
    for (const std::string& line : lines_of(text_))
      if (line.starts_with("| " + first_cell + " |")) return line + '\n';
    return {};
  }

  /// All from a heading to the next, or to the end of the tables.
  std::string section(const std::string& heading) const {
    const std::string title = "### " + heading + '\n';
    const std::size_t begin = text_.find('\n' + title) + 1;
    if (begin == 0) return {};
    return text_.substr(begin, std::min(text_.find("\n### ", begin), text_.find("\n<!--", begin)) + 1 - begin);
  }

  /// First cells of all rows, and headings ("### wedges"), in their order; heads of tables left out.
  std::vector<std::string> names() const {
    std::vector<std::string> names, lines = lines_of(text_);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool head = i + 1 < lines.size() && (lines[i + 1].starts_with("|---") || lines[i + 1].starts_with("|--:"));
      if (lines[i].starts_with("### ")) names.push_back(lines[i]);
      if (lines[i].starts_with("| ") && !head) names.push_back(lines[i].substr(2, lines[i].find(" |", 2) - 2));
    }
    return names;
  }

 private:
  std::string text_;
};

}  // namespace talus::test
