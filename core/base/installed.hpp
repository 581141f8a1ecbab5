#pragma once

#include <filesystem>

namespace talus {

/// Folder of the running program, links followed; empty where the system does not tell it.
std::filesystem::path program_folder();

/// What was installed with the running program, wherever that was moved to since: `place` below the folder that holds
/// its bin, like "share/talus/samples". Where there is no such thing, `built`: a program in its build folder takes
/// that.
std::filesystem::path installed_or(const std::filesystem::path& place, const std::filesystem::path& built);

}  // namespace talus
