#include "geometry/mesher_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace talus {
namespace {

std::filesystem::path find_mesher() {
  if (const char* named = std::getenv("TALUS_MESHER")) return named;
  std::error_code unreadable;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", unreadable).parent_path();
  for (const std::filesystem::path& candidate :
       {here / "talus-mesher", here / "../libexec/talus/talus-mesher", std::filesystem::path(TALUS_MESHER_BUILT)}) {
    if (access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  throw std::runtime_error("the program talus-mesher is not beside this program; set TALUS_MESHER to its path");
}

/// What the new program starts with: the socket as its standard input, silence on its outputs (OpenCASCADE writes
/// to them), default signals, and a process group of its own so that Ctrl-C in a terminal reaches the caller alone.
class SpawnSetup {
 public:
  explicit SpawnSetup(int socket) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, socket, 0);
    for (int output : {1, 2}) posix_spawn_file_actions_addopen(&actions_, output, "/dev/null", O_WRONLY, 0);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;

  int start(pid_t& process, std::string program) const {
    char* arguments[] = {program.data(), nullptr};
    return posix_spawn(&process, program.c_str(), &actions_, &attributes_, arguments, environ);
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

MesherProcess::MesherProcess() {
  const std::string program = find_mesher().string();
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot open a socket to the mesher");
  }
  const int error = SpawnSetup(ends[1]).start(process_, program);
  close(ends[1]);
  socket_ = ends[0];
  if (error != 0) {
    close(socket_);
    throw std::system_error(error, std::generic_category(), "cannot start " + program);
  }
}

MesherProcess::~MesherProcess() {
  close(socket_);
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void MesherProcess::send(MessageKind kind, const std::string& bytes) {
  const MessageHeader header{kind, bytes.size()};
  const std::string all = std::string(reinterpret_cast<const char*>(&header), sizeof header) + bytes;
  for (std::size_t sent = 0; sent < all.size();) {
    const ssize_t count = ::send(socket_, all.data() + sent, all.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

bool MesherProcess::wait(int milliseconds) const {
  pollfd watched{socket_, POLLIN, 0};
  return poll(&watched, 1, milliseconds) > 0;
}

std::optional<MesherProcess::Message> MesherProcess::receive() {
  const auto receive_exactly = [this](char* into, std::size_t size) {
    while (size > 0) {
      const ssize_t count = recv(socket_, into, size, 0);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      into += count;
      size -= static_cast<std::size_t>(count);
    }
    return true;
  };
  MessageHeader header;
  if (!receive_exactly(reinterpret_cast<char*>(&header), sizeof header)) return std::nullopt;
  Message message{header.kind, std::string(header.size, '\0')};
  if (!receive_exactly(message.bytes.data(), message.bytes.size())) return std::nullopt;
  return message;
}

}  // namespace talus
