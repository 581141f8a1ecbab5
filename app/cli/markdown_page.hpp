#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus::cli {

/// Writes `text` into `file`, in place of what stands between the lines `<!-- talus-cli verify: begin -->` and
/// `<!-- talus-cli verify: end -->`; the rest of the page is kept. Throws InputError for a file that cannot be read or
/// written, or has no such lines.
void write_into_page(const std::filesystem::path& file, const std::string& text);

/// Throws InputError as `write_into_page` would: asked before hours of computing.
void check_page(const std::filesystem::path& file);

/// A table's first two lines; `alignment`: a letter a column, l or r.
std::string markdown_heading(const std::vector<std::string>& columns, const std::string& alignment);
/// A row; what would end a cell is escaped.
std::string markdown_row(const std::vector<std::string>& cells);

}  // namespace talus::cli
