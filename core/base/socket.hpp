#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

namespace talus {

/// One end of two connected sockets, the other of which another program has. Closed when destroyed.
class Socket {
 public:
  explicit Socket(int descriptor = -1) : descriptor_(descriptor) {}
  ~Socket();
  Socket(Socket&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Socket& operator=(Socket&& other) noexcept;

  /// False once the other end is closed.
  bool send(std::string_view bytes);
  /// The same, and with the first byte, of which there must be one, an open socket, which the other program has then
  /// as well.
  bool send_with(std::string_view bytes, const Socket& also);
  /// Whether something has come, or the other end is closed, within the time.
  bool wait(int milliseconds) const;
  /// Up to `size` bytes as soon as some have come; 0 once the other end is closed.
  std::size_t read(char* into, std::size_t size);
  /// The same; with them comes what was sent along, or a socket that is closed.
  std::pair<std::size_t, Socket> read_with(char* into, std::size_t size);
  /// What was sent is the last; what comes is still read.
  void finish();

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

/// Two ends. Programs that are started inherit neither. Throws std::system_error where there are no more.
std::pair<Socket, Socket> connected_sockets();

}  // namespace talus
