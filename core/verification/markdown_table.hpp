#pragma once

#include <string>
#include <vector>

namespace talus {

/// A Markdown table's first two lines; `alignment`: a letter a column, l or r.
std::string markdown_heading(const std::vector<std::string>& columns, const std::string& alignment);
/// A row; what would end a cell is escaped.
std::string markdown_row(const std::vector<std::string>& cells);

/// Text in lines of at most 120 characters, those after the first with `indent` before them.
std::string markdown_paragraph(const std::string& text, const std::string& indent = "");

}  // namespace talus
