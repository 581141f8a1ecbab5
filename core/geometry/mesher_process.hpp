#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/socket.hpp"
#include "geometry/mesher_job.hpp"

namespace talus {

/// The program talus-mesher, at one job, and spoken to in messages; destroying this ends it at once.
/// Looked for at the path in TALUS_MESHER, beside the running program, in ../libexec/talus from there, and where it
/// was built. Throws std::runtime_error when it is nowhere or does not start.
class MesherProcess {
 public:
  struct Message {
    MessageKind kind;
    std::string bytes;
  };

  /// The job, or what is to be looked at.
  MesherProcess(MessageKind kind, const std::string& bytes);
  ~MesherProcess();

  /// Nothing is thrown when it has died: the next wait() tells.
  void send(MessageKind kind, const std::string& bytes);

  /// Whether something has come, or it has died, within the time.
  bool wait(int milliseconds) const { return socket_.wait(milliseconds); }

  /// The next message, after wait(); nothing once it has ended or died. Throws InputError where it is of another
  /// version of Talus, whose messages are not understood.
  std::optional<Message> receive();

 private:
  std::filesystem::path program_;
  Socket socket_;
};

}  // namespace talus
