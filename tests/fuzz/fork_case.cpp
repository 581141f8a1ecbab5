/// A program that is a case of the one that is served at TALUS_CASES_AT (fork_server.cpp): to who starts it, it is that
/// program. It hands on arguments and streams, and ends as the case does.

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

int connected() {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::snprintf(address.sun_path, sizeof address.sun_path, "%s", std::getenv("TALUS_CASES_AT"));
  const int socket = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  return connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ? socket : -1;
}

bool send_case(int socket, std::string arguments) {
  const int streams[] = {0, 1, 2};
  iovec part{arguments.data(), arguments.size()};
  alignas(cmsghdr) char room[CMSG_SPACE(sizeof streams)] = {};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = room;
  message.msg_controllen = sizeof room;
  cmsghdr* sent = CMSG_FIRSTHDR(&message);
  sent->cmsg_level = SOL_SOCKET;
  sent->cmsg_type = SCM_RIGHTS;
  sent->cmsg_len = CMSG_LEN(sizeof streams);
  std::memcpy(CMSG_DATA(sent), streams, sizeof streams);
  return sendmsg(socket, &message, MSG_NOSIGNAL) == static_cast<ssize_t>(part.iov_len);
}

}  // namespace

int main(int count, char** words) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // as the jobs of talus-mesher; the case goes with this
  std::string arguments;
  for (int i = 0; i < count; ++i) arguments += std::string(words[i]) + '\0';
  const int socket = connected();
  int status = 0;
  const bool is_sent = socket >= 0 && send_case(socket, arguments);
  close(STDIN_FILENO);  // the case has it alone: who holds its other end hears when that is closed
  if (!is_sent || recv(socket, &status, sizeof status, MSG_WAITALL) != sizeof status) {
    std::perror("fork case");
    return 1;
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  const rlimit none{0, 0};  // no second core file
  setrlimit(RLIMIT_CORE, &none);
  std::signal(WTERMSIG(status), SIG_DFL);
  raise(WTERMSIG(status));
  return 1;
}
