#pragma once

#include <filesystem>
#include <string>

namespace talus::cli {

/// Writes `text` into `file`, in place of what stands between the lines `<!-- talus-cli verify: begin -->` and
/// `<!-- talus-cli verify: end -->`; the rest of the page is kept. Throws InputError for a file that cannot be read or
/// written, or has no such lines.
void write_into_page(const std::filesystem::path& file, const std::string& text);

/// Throws InputError as `write_into_page` would: asked before hours of computing.
void check_page(const std::filesystem::path& file);

}  // namespace talus::cli
