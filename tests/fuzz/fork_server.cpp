/// A library that is loaded before a program's own (LD_PRELOAD): the program starts once, and its main is called again
/// and again, each time in a fork of the program as it was before main. What a start costs, most of it the search for
/// names in two hundred libraries, is paid once.
///
/// It listens at the socket that TALUS_FORKS_AT names. Who connects is one case: it sends the program's name and its
/// arguments, each ended by a zero, and with them its standard input, output and error (served.py; fork_case.cpp). How
/// that ended, as waitpid has it, comes back as an int. The case is killed where the other end is closed before.

#include <dlfcn.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

using Main = int (*)(int, char**, char**);
constexpr int streams = 3;
constexpr std::size_t longest_case = 1 << 16;  // bytes of all arguments

Main main_of_program = nullptr;

struct Case {
  std::vector<std::string> words;
  int stream[streams];
};

/// Its words are empty where nothing whole came.
Case receive(int connection) {
  std::string bytes(longest_case, '\0');
  iovec part{bytes.data(), bytes.size()};
  alignas(cmsghdr) char room[CMSG_SPACE(sizeof Case::stream)];
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = room;
  message.msg_controllen = sizeof room;
  const ssize_t size = recvmsg(connection, &message, 0);
  const cmsghdr* sent = CMSG_FIRSTHDR(&message);
  Case received{};
  if (size <= 0 || sent == nullptr || sent->cmsg_len != CMSG_LEN(sizeof received.stream)) return received;
  std::memcpy(received.stream, CMSG_DATA(sent), sizeof received.stream);
  for (const char* at = bytes.data(); at < bytes.data() + size; at += received.words.back().size() + 1)
    received.words.emplace_back(at);
  return received;
}

int as_program(Case given) {
  for (int s = 0; s < streams; ++s) {
    dup2(given.stream[s], s);
    close(given.stream[s]);
  }
  std::vector<char*> pointers;
  for (std::string& word : given.words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return main_of_program(static_cast<int>(given.words.size()), pointers.data(), environ);
}

/// How the process ended, as waitpid has it.
int end_of(pid_t process, int connection) {
  const int watched = static_cast<int>(syscall(SYS_pidfd_open, process, 0));  // glibc 2.36 declares it for C alone
  pollfd either[] = {{watched, POLLIN, 0}, {connection, POLLIN, 0}};
  while (poll(either, 2, -1) < 0) {
  }
  if (either[0].revents == 0) kill(process, SIGKILL);
  close(watched);
  int status = 0;
  waitpid(process, &status, 0);
  return status;
}

int listening_socket() {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::snprintf(address.sun_path, sizeof address.sun_path, "%s", std::getenv("TALUS_FORKS_AT"));
  const int socket = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  const bool listens =
      bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 && listen(socket, 8) == 0;
  if (!listens) std::perror("fork server");
  return listens ? socket : -1;
}

/// Until it is killed.
int serve(int, char**, char**) {
  const int socket = listening_socket();
  if (socket < 0) return 1;
  unsetenv("LD_PRELOAD");
  for (;;) {
    const int connection = accept4(socket, nullptr, nullptr, SOCK_CLOEXEC);
    Case given = receive(connection);
    if (!given.words.empty()) {
      const pid_t process = fork();
      if (process == 0) {
        close(connection);
        close(socket);
        return as_program(std::move(given));
      }
      for (const int stream : given.stream) close(stream);
      const int status = end_of(process, connection);
      send(connection, &status, sizeof status, MSG_NOSIGNAL);
    }
    close(connection);
  }
}

}  // namespace

/// What the start of every program calls with its main.
extern "C" int __libc_start_main(Main main, int count, char** arguments, void (*begin)(), void (*end)(),
                                 void (*end_of_loader)(), void* stack) {
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  main_of_program = main;
  const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(serve, count, arguments, begin, end, end_of_loader, stack);
}
