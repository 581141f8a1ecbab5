#include "base/child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <system_error>

namespace talus {
namespace {

/// What the new program starts with.
class SpawnSetup {
 public:
  SpawnSetup(int socket, const ChildProgram& program) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, socket, program.channel);
    if (program.channel != 0) posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    for (const int output : {1, 2})
      if (output != program.channel)
        posix_spawn_file_actions_addopen(&actions_, output, program.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
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

  int start(pid_t& process, const ChildProgram& program) const {
    std::vector<std::string> words{program.program.string()};
    words.insert(words.end(), program.arguments.begin(), program.arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return posix_spawnp(&process, words.front().c_str(), &actions_, &attributes_, pointers.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

ChildProcess::ChildProcess(const ChildProgram& program) {
  auto [ours, its] = connected_sockets();
  socket_ = std::move(ours);
  const int error = SpawnSetup(its.descriptor(), program).start(process_, program);
  if (error != 0) throw std::system_error(error, std::generic_category(), "cannot start " + program.program.string());
}

ChildProcess::~ChildProcess() {
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

int ChildProcess::exit_code() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

ProgramOutput output_of(const std::string& program, const std::vector<std::string>& arguments,
                        const std::filesystem::path& log) {
  ChildProcess child({program, arguments, 1, log});
  ProgramOutput output;
  char bytes[4096];
  while (const std::size_t count = child.socket().read(bytes, sizeof bytes)) output.text.append(bytes, count);
  output.exit_code = child.exit_code();
  return output;
}

}  // namespace talus
