#include "base/socket.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace talus {
namespace {

constexpr std::size_t room_for_one = CMSG_SPACE(sizeof(int));

/// What was sent with a message.
Socket sent_along(msghdr& message) {
  const cmsghdr* sent = CMSG_FIRSTHDR(&message);
  if (sent == nullptr || sent->cmsg_type != SCM_RIGHTS || sent->cmsg_len != CMSG_LEN(sizeof(int))) return Socket();
  int descriptor = -1;
  std::memcpy(&descriptor, CMSG_DATA(sent), sizeof descriptor);
  return Socket(descriptor);
}

}  // namespace

Socket::~Socket() {
  if (descriptor_ >= 0) close(descriptor_);
}

Socket& Socket::operator=(Socket&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

bool Socket::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool Socket::send_with(std::string_view bytes, const Socket& also) {
  std::string_view rest = bytes;
  iovec part{const_cast<char*>(bytes.data()), bytes.size()};
  alignas(cmsghdr) char room[room_for_one] = {};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = room;
  message.msg_controllen = sizeof room;
  cmsghdr* sent = CMSG_FIRSTHDR(&message);
  sent->cmsg_level = SOL_SOCKET;
  sent->cmsg_type = SCM_RIGHTS;
  sent->cmsg_len = CMSG_LEN(sizeof also.descriptor_);
  std::memcpy(CMSG_DATA(sent), &also.descriptor_, sizeof also.descriptor_);
  ssize_t count = 0;
  while ((count = sendmsg(descriptor_, &message, MSG_NOSIGNAL)) < 0 && errno == EINTR) {
  }
  if (count < 0) return false;
  rest.remove_prefix(static_cast<std::size_t>(count));
  return send(rest);
}

bool Socket::wait(int milliseconds) const {
  pollfd watched{descriptor_, POLLIN, 0};
  return poll(&watched, 1, milliseconds) > 0;
}

std::size_t Socket::read(char* into, std::size_t size) {
  for (;;) {
    const ssize_t count = recv(descriptor_, into, size, 0);
    if (count < 0 && errno == EINTR) continue;
    return count < 0 ? 0 : static_cast<std::size_t>(count);
  }
}

std::pair<std::size_t, Socket> Socket::read_with(char* into, std::size_t size) {
  iovec part{into, size};
  alignas(cmsghdr) char room[room_for_one];
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = room;
  message.msg_controllen = sizeof room;
  ssize_t count = 0;
  while ((count = recvmsg(descriptor_, &message, MSG_CMSG_CLOEXEC)) < 0 && errno == EINTR) {
  }
  if (count <= 0) return {0, Socket()};
  return {static_cast<std::size_t>(count), sent_along(message)};
}

void Socket::finish() { shutdown(descriptor_, SHUT_WR); }

std::pair<Socket, Socket> connected_sockets() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot open a socket");
  return {Socket(ends[0]), Socket(ends[1])};
}

}  // namespace talus
