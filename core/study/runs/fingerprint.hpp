#pragma once

#include <filesystem>
#include <string>

#include "model/project.hpp"

namespace talus {

/// By which a project is known again: hangs on its text and on the files that it names, which are looked for in
/// `folder`. Sixteen digits. Throws InputError for a file that cannot be read.
std::string fingerprint_of(const std::string& text, const Project& project, const std::filesystem::path& folder);

}  // namespace talus
