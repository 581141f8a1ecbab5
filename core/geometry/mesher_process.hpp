#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "geometry/mesher_job.hpp"

namespace talus {

/// The program talus-mesher, running. It is started afresh (spawned, not forked: the window's threads and its graphics
/// must not be copied) and spoken to through a socket; destroying this kills it.
/// Looked for at the path in TALUS_MESHER, beside the running program, in ../libexec/talus from there, and where it
/// was built. Throws std::runtime_error when it is nowhere or does not start.
class MesherProcess {
 public:
  struct Message {
    MessageKind kind;
    std::string bytes;
  };

  MesherProcess();
  ~MesherProcess();
  MesherProcess(const MesherProcess&) = delete;
  MesherProcess& operator=(const MesherProcess&) = delete;

  /// Nothing is thrown when it has died: the next wait() tells.
  void send(MessageKind kind, const std::string& bytes);

  /// Whether something has come, or it has died, within the time.
  bool wait(int milliseconds) const;

  /// The next message, after wait(); nothing once it has ended or died.
  std::optional<Message> receive();

 private:
  pid_t process_ = -1;
  int socket_ = -1;
};

}  // namespace talus
