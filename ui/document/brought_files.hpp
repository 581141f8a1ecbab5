#pragma once

#include <filesystem>

#include "model/project.hpp"

namespace talus {

/// Copies a file; an equal one is left alone, as is a source that is missing. Throws InputError where another file is
/// in the way, or it cannot be written.
void bring_file(const std::filesystem::path& source, const std::filesystem::path& target);

/// Copies the files that the project names by relative paths from one folder to another, so that it finds them there.
/// Throws InputError as `bring_file` does.
void bring_files(const Project& project, const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace talus
