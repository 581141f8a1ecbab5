#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace talus::test {

/// A temporary folder that goes with the test.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string text_of(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);

/// What a process left behind.
struct Ending {
  int exit_code = -1;  ///< −1 when a signal ended it
  int signal = 0;
  std::string out, err;
};

/// talus-cli as a process with no display, its standard input from a file, its standard output and error in files.
class Cli {
 public:
  explicit Cli(const std::vector<std::string>& arguments, const std::filesystem::path& input = "/dev/null");
  ~Cli();
  Cli(const Cli&) = delete;
  Cli& operator=(const Cli&) = delete;

  void send(int signal) const;
  /// What it has written to standard error so far.
  std::string said() const;
  /// Fails the test after two minutes and kills the process.
  Ending wait();

 private:
  Folder streams_;
  pid_t process_ = -1;
  bool ended_ = false;
};

/// Runs talus-cli to its end.
Ending talus_cli(const std::vector<std::string>& arguments, const std::filesystem::path& input = "/dev/null");

/// A sample's project file.
std::string sample(const std::string& name);

}  // namespace talus::test
