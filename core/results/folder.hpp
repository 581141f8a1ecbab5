#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace talus {

/// A file of the results cannot be written: the disk is full, or the folder has gone.
struct WriteError : InputError {
  WriteError(const std::filesystem::path& file, const std::string& reason)
      : InputError(file.string(), "cannot be written: " + reason, "make room on the disk, or choose another --out") {}
  /// For the reason that the system gives.
  explicit WriteError(const std::filesystem::path& file);
};

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

/// Whether a run holds the folder's lock.
bool is_written_to(const std::filesystem::path& folder);

/// A process that holds a folder's lock.
struct FolderWriter {
  int process = 0;
  std::string program;  ///< "talus-cli", "talus"
};
/// Which of this user's processes on this machine writes into the folder; none also where the system does not tell.
std::optional<FolderWriter> writer_of(const std::filesystem::path& folder);

/// What to call results that are shown beside each other: "phi20" of out/phi20.results, and where two are called so as
/// much of the way there as tells them apart: "dry/phi20" and "wet/phi20".
std::vector<std::string> names_of_results(const std::vector<std::filesystem::path>& folders);

/// Cuts a file off behind its first `size` bytes. Throws std::runtime_error, with the path, where it has fewer.
void cut_off(const std::filesystem::path& file, std::uint64_t size);

/// Has the file on the disk when it returns: what lies in the system's memory only goes with its power. Throws
/// WriteError.
void flush_to_disk(const std::filesystem::path& file);

/// Puts a file that is whole into the place of another one. Throws WriteError.
void rename_file(const std::filesystem::path& fresh, const std::filesystem::path& file);

/// Writes a file so that its old content, if any, stays until all of the new is there.
/// Throws WriteError.
void replace_file(const std::filesystem::path& file, std::string_view text);
/// The same of a text that is too long to be held whole: `write` puts it there piece by piece.
void replace_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

}  // namespace talus
