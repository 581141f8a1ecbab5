#pragma once

#include <filesystem>
#include <vector>

#include "study/verify.hpp"

namespace talus::cli {

/// Writes the results as Markdown tables into `file`, in place of what stands between the lines
/// `<!-- talus-cli verify: begin -->` and `<!-- talus-cli verify: end -->`; the rest of the page is kept.
/// Throws InputError for a file that cannot be read or written, or has no such lines.
void write_markdown(const std::filesystem::path& file, const std::vector<CaseResult>& results);

/// Throws InputError as `write_markdown` would: asked before hours of computing.
void check_markdown(const std::filesystem::path& file);

}  // namespace talus::cli
