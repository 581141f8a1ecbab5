#include "markdown_page.hpp"

#include <fstream>
#include <sstream>

#include "base/error.hpp"

namespace talus::cli {

namespace {

const std::string begin_line = "<!-- talus-cli verify: begin -->\n", end_line = "<!-- talus-cli verify: end -->\n";

/// A cell that does not end the table's row.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

struct Page {
  std::string before, after;  ///< the generated part, with its marker lines
};

Page page_in(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  const std::string page = text.str();
  const std::size_t begin = page.find(begin_line), end = page.find(end_line);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    throw InputError(file.string(), "has no part for the tables of verify",
                     "give a page that holds the lines <!-- talus-cli verify: begin --> and "
                     "<!-- talus-cli verify: end -->");
  return {page.substr(0, begin + begin_line.size()), page.substr(end)};
}

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

void check_page(const std::filesystem::path& file) { page_in(file); }

void write_into_page(const std::filesystem::path& file, const std::string& text) {
  const Page page = page_in(file);
  std::ofstream stream(file);
  stream << page.before << '\n' << text << page.after;
  stream.close();
  if (!stream) throw InputError(file.string(), "cannot be written", "check the path and its permissions");
}

}  // namespace talus::cli
