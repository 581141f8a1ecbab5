#pragma once

#include <filesystem>

namespace talus {

/// A new empty folder that goes with its owner.
class TemporaryFolder {
 public:
  /// Throws std::system_error when there is no room for one.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace talus
