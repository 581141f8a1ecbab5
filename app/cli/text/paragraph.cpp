#include "text/paragraph.hpp"

#include <sstream>

#include "text/table.hpp"

namespace talus::cli {

std::string paragraph(const std::string& text, std::size_t indent) {
  constexpr std::size_t paragraph_width = 110;
  const std::string margin(indent, ' ');
  std::istringstream words(text);
  std::string lines, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && indent + width_of(line) + 1 + width_of(word) > paragraph_width) {
      lines += margin + line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? lines : lines + margin + line + '\n';
}

}  // namespace talus::cli
