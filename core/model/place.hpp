#pragma once

#include <cstddef>
#include <string>
#include <utility>

namespace talus {

/// A place in the project as a JSON pointer (RFC 6901): `Place() / "cuts" / 2 / "joint"` is "/cuts/2/joint".
class Place {
 public:
  Place() = default;

  Place operator/(const std::string& key) const { return Place(pointer_ + '/' + escaped(key)); }
  Place operator/(std::size_t index) const { return Place(pointer_ + '/' + std::to_string(index)); }

  /// The pointer; the whole project is "/" to the reader of a message.
  std::string text() const { return pointer_.empty() ? "/" : pointer_; }
  const std::string& pointer() const { return pointer_; }

 private:
  explicit Place(std::string pointer) : pointer_(std::move(pointer)) {}

  static std::string escaped(const std::string& key) {
    std::string text;
    for (const char c : key) {
      if (c == '~')
        text += "~0";
      else if (c == '/')
        text += "~1";
      else
        text += c;
    }
    return text;
  }

  std::string pointer_;
};

}  // namespace talus
