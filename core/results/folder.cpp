#include "results/folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "base/error.hpp"

namespace talus {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 17> our_files = {
    "results.h5",     "results.vtkhdf",   "results.vtkhdf.new", "results.xdmf",  "frames.h5",
    "history.csv",    "steps.csv",        "checkpoint.h5",      "log.txt",       "project.talus",
    "summary.json",   "summary.json.new", "results.xdmf.new",   "frames.h5.new", "checkpoint.h5.new",
    "results.h5.new", "background.txt"};

bool is_ours(const fs::path& entry) { return std::ranges::count(our_files, entry.filename().string()) > 0; }

/// Whether a process holds the folder open. Numbers of devices in /proc/locks are not those of stat() on all file
/// systems, so a number that a file of another one has, too, would mislead.
bool has_open(const fs::path& process, const struct stat& folder) {
  std::error_code forbidden;
  for (const fs::directory_entry& descriptor : fs::directory_iterator(process / "fd", forbidden)) {
    struct stat held {};
    if (::stat(descriptor.path().c_str(), &held) == 0 && held.st_dev == folder.st_dev && held.st_ino == folder.st_ino)
      return true;
  }
  return false;
}

}  // namespace

void prepare_results_folder(const fs::path& folder) {
  const std::string place = folder.string();
  std::error_code problem;
  if (fs::exists(folder, problem) && !fs::is_directory(folder, problem))
    throw InputError(place, "is a file, not a folder", "choose another --out");
  fs::create_directories(folder, problem);
  if (problem) throw InputError(place, "cannot be made: " + problem.message(), "choose another --out");

  const fs::directory_iterator entries(folder, problem);
  if (problem) throw InputError(place, "cannot be read: " + problem.message(), "choose another --out");
  std::vector<fs::path> earlier;
  bool empty = true, has_results = false;
  for (const fs::directory_entry& entry : entries) {
    empty = false;
    if (is_ours(entry.path()) && entry.is_regular_file()) earlier.push_back(entry.path());
    has_results = has_results || entry.path().filename() == "results.h5" ||
                  entry.path().filename() == "results.h5.new";  // of a run that was killed in its first moments
  }
  // A folder with nothing but a project.talus may be the user's own.
  if (!empty && !has_results) throw InputError(place, "holds files that are not results", "choose another --out");
  if (has_results) const FolderLock nobody_writes(folder);
  // By results.h5 a folder is known as one of results, also where a kill leaves it half cleared: that goes last.
  std::stable_partition(earlier.begin(), earlier.end(),
                        [](const fs::path& file) { return file.filename() != "results.h5"; });
  for (const fs::path& file : earlier) {
    fs::remove(file, problem);
    if (problem) throw InputError(file.string(), "cannot be removed: " + problem.message(), "choose another --out");
  }
}

WriteError::WriteError(const fs::path& file) : WriteError(file, std::generic_category().message(errno)) {}

FolderLock::FolderLock(const fs::path& folder) : descriptor_(::open(folder.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  if (descriptor_ >= 0) ::close(descriptor_);
  throw InputError(folder.string(), "another run writes its results there", "wait for it or choose another --out");
}

FolderLock::~FolderLock() { ::close(descriptor_); }

bool is_written_to(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool taken = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return taken;
}

std::optional<FolderWriter> writer_of(const fs::path& folder) {
  struct stat wanted {};
  if (::stat(folder.c_str(), &wanted) != 0) return std::nullopt;
  std::ifstream locks("/proc/locks");
  for (std::string line; std::getline(locks, line);) {  // "1: FLOCK  ADVISORY  WRITE 812 08:01:5678 0 EOF"
    std::string number, kind, mode, access, process, place;
    std::istringstream(line) >> number >> kind >> mode >> access >> process >> place;
    if (kind != "FLOCK" || access != "WRITE" || !place.ends_with(":" + std::to_string(wanted.st_ino))) continue;
    const fs::path described = fs::path("/proc") / process;
    FolderWriter writer{std::atoi(process.c_str()), {}};
    if (has_open(described, wanted) && std::getline(std::ifstream(described / "comm"), writer.program)) return writer;
  }
  return std::nullopt;
}

std::vector<std::string> names_of_results(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::filesystem::path> rest;  // of each, what lies before its name
  std::vector<std::string> names;
  for (const std::filesystem::path& folder : folders) {
    rest.push_back(std::filesystem::weakly_canonical(folder));
    names.push_back(rest.back().stem().string());
  }
  const auto is_alone = [&](std::size_t i) { return std::ranges::count(names, names[i]) == 1; };
  for (bool grew = true; grew;) {
    grew = false;
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (!is_alone(i)) alike.push_back(i);
    for (const std::size_t i : alike) {
      rest[i] = rest[i].parent_path();
      if (!rest[i].has_filename()) continue;
      names[i] = (rest[i].filename() / names[i]).string();
      grew = true;
    }
  }
  return names;
}

void cut_off(const fs::path& file, std::uint64_t size) {
  std::error_code problem;
  const std::uint64_t present = fs::file_size(file, problem);
  if (problem || present < size) throw std::runtime_error(file.string() + ": is missing or has been cut off");
  fs::resize_file(file, size);
}

void flush_to_disk(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw WriteError(file);
  const bool is_there = ::fsync(descriptor) == 0;
  ::close(descriptor);
  if (!is_there) throw WriteError(file);
}

void rename_file(const fs::path& fresh, const fs::path& file) {
  std::error_code problem;
  fs::rename(fresh, file, problem);
  if (problem) throw WriteError(file, problem.message());
}

void replace_file(const fs::path& file, std::string_view text) {
  replace_file(file, [&](std::ostream& stream) { stream << text; });
}

void replace_file(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  const fs::path fresh = file.string() + ".new";
  std::ofstream stream(fresh, std::ios::binary | std::ios::trunc);
  write(stream);
  stream.close();
  if (!stream) throw WriteError(fresh);
  rename_file(fresh, file);
}

}  // namespace talus
