#pragma once

#include <filesystem>
#include <string>

namespace talus::cli {

/// Writes what a command makes, whole or not at all. Throws InputError whose place begins with the file.
void write_output(const std::filesystem::path& file, const std::string& bytes);

}  // namespace talus::cli
