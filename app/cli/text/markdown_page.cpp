#include "text/markdown_page.hpp"

#include <fstream>
#include <sstream>

#include "base/error.hpp"

namespace talus::cli {

namespace {

const std::string begin_line = "<!-- talus-cli verify: begin -->\n", end_line = "<!-- talus-cli verify: end -->\n";

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

void check_page(const std::filesystem::path& file) { page_in(file); }

void write_into_page(const std::filesystem::path& file, const std::string& text) {
  const Page page = page_in(file);
  std::ofstream stream(file);
  stream << page.before << '\n' << text << page.after;
  stream.close();
  if (!stream) throw InputError(file.string(), "cannot be written", "check the path and its permissions");
}

}  // namespace talus::cli
