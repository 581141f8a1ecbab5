#include "base/one_line.hpp"

#include <algorithm>

namespace talus {

namespace {

/// Where the UTF-8 character begins that the byte at `at` belongs to.
std::size_t character_start(const std::string& text, std::size_t at) {
  while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80) --at;
  return at;
}

}  // namespace

std::string one_line(std::string message) {
  constexpr std::size_t most = 480, kept_at_end = 180;
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  if (message.size() <= most) return message;
  const std::string between = " … ";
  const std::size_t again = character_start(message, message.size() - kept_at_end);
  const std::size_t end = character_start(message, most - (message.size() - again) - between.size());
  return message.substr(0, end) + between + message.substr(again);
}

}  // namespace talus
