#pragma once

#include <filesystem>
#include <vector>

namespace talus {

/// The projects that files and folders name: of a folder all in it and below, by name, but for what lies in folders
/// that Talus writes (results and studies). Throws InputError for a folder without any.
std::vector<std::filesystem::path> projects_in(const std::vector<std::filesystem::path>& files_and_folders);

}  // namespace talus
