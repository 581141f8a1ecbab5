#pragma once

#include <filesystem>
#include <string>

namespace talus {

/// The bytes of a file. Throws InputError ("cannot be read: no such file") when there are none to be had.
std::string read_whole_file(const std::filesystem::path& file);

/// Replaces a file by way of a temporary one beside it that reaches the disk first: whatever happens, the file holds
/// either the old bytes or the new ones. A link is followed; permissions stay. Throws InputError when it cannot.
void replace_whole_file(const std::filesystem::path& file, const std::string& bytes);

}  // namespace talus
