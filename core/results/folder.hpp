#pragma once

#include <filesystem>
#include <string_view>

namespace talus {

/// Makes the folder, or removes earlier results from one that holds them; other files there, pictures for example,
/// stay. Throws InputError when it holds files but no results, is a file, cannot be made, or when a run still writes
/// there.
void prepare_results_folder(const std::filesystem::path& folder);

/// Held while a run writes into the folder, so that no second one does. Goes with the process, however it ends.
class FolderLock {
 public:
  /// Throws InputError when another holds it.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_ = -1;
};

/// Writes a file so that its old content, if any, stays until all of the new is there.
/// Throws std::runtime_error with the path.
void replace_file(const std::filesystem::path& file, std::string_view text);

}  // namespace talus
