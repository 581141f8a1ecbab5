#include "base/installed.hpp"

#include <system_error>

namespace talus {

std::filesystem::path program_folder() {
  std::error_code unreadable;
  return std::filesystem::read_symlink("/proc/self/exe", unreadable).parent_path();
}

std::filesystem::path installed_or(const std::filesystem::path& place, const std::filesystem::path& built) {
  const std::filesystem::path installed = program_folder().parent_path() / place;
  std::error_code unreadable;
  return std::filesystem::exists(installed, unreadable) ? installed : built;
}

}  // namespace talus
