#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/socket.hpp"

namespace talus {

/// How a program is started in a process of its own.
struct ChildProgram {
  std::filesystem::path program;
  std::vector<std::string> arguments{};
  int channel = 0;                          ///< which of its streams is the socket to us: 0 its input, 1 its output
  std::filesystem::path log = "/dev/null";  ///< where its other outputs go
};

/// A program that runs beside this one. It is started afresh (spawned, not forked: the window's threads and its
/// graphics must not be copied), with default signals and in a process group of its own, so that Ctrl-C in a terminal
/// reaches the caller alone. A socket leads to it; destroying this closes that and kills it.
class ChildProcess {
 public:
  /// Throws std::system_error when it does not start.
  explicit ChildProcess(const ChildProgram& program);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Nothing is thrown when it has died: the next reading tells.
  Socket& socket() { return socket_; }
  const Socket& socket() const { return socket_; }

  /// Waits for its end: the exit code, or 128 + the signal that ended it, as shells have it.
  int exit_code();

 private:
  int process_ = -1;
  Socket socket_;
};

/// What a program says on its standard output, and how it ended.
struct ProgramOutput {
  std::string text;
  int exit_code = 0;
};
/// Runs a program, found through PATH, to its end. Throws std::system_error when it does not start.
ProgramOutput output_of(const std::string& program, const std::vector<std::string>& arguments,
                        const std::filesystem::path& log = "/dev/null");

}  // namespace talus
