#include "io/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "base/error.hpp"

namespace talus {
namespace {

std::string system_words(int code) { return std::generic_category().message(code); }

/// A temporary file that removes itself unless it took the other's place.
class ReplacementFile {
 public:
  explicit ReplacementFile(const std::filesystem::path& target) : target_(target), path_(target) {
    path_ += ".new-" + std::to_string(::getpid());
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail();
  }
  ~ReplacementFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!in_place_) ::unlink(path_.c_str());
  }
  ReplacementFile(const ReplacementFile&) = delete;
  ReplacementFile& operator=(const ReplacementFile&) = delete;

  void write(const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
      const auto count = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      done += static_cast<std::size_t>(count);
    }
  }

  void take_place() {
    std::error_code none;
    const auto old = std::filesystem::status(target_, none);
    if (std::filesystem::exists(old)) std::filesystem::permissions(path_, old.permissions(), none);
    if (::fsync(descriptor_) != 0) fail();
    if (std::rename(path_.c_str(), target_.c_str()) != 0) fail();
    in_place_ = true;
  }

 private:
  [[noreturn]] void fail() const {
    throw InputError("cannot be written", system_words(errno), "check the folder's permissions and the free space");
  }

  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  bool in_place_ = false;
};

}  // namespace

std::string read_whole_file(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (std::filesystem::is_directory(status))
    throw InputError("cannot be read", "it is a folder", "name the .talus file in it");
  if (std::filesystem::is_other(status))  // it may never end, or never begin
    throw InputError("cannot be read", "it is a pipe or a device", "write it into a file");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string bytes;
  if (stream) bytes.assign(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || stream.bad()) {
    const bool missing = errno == ENOENT;
    throw InputError("cannot be read", missing ? "no such file" : system_words(errno),
                     missing ? "check the name and the folder" : "check the file's permissions");
  }
  return bytes;
}

void replace_whole_file(const std::filesystem::path& file, const std::string& bytes) {
  std::error_code error;
  auto target = file;
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(file, error))) {
    target = std::filesystem::canonical(file, error);
    if (error) throw InputError("cannot be written", "it is a link that leads nowhere", "remove it or save elsewhere");
  }
  ReplacementFile replacement(target);
  replacement.write(bytes);
  replacement.take_place();
}

}  // namespace talus
