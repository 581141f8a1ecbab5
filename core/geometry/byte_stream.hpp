#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/hash.hpp"
#include "base/vector.hpp"

/// Values as bytes, for the pipe between the program and the mesher it starts: same machine, same build, so native
/// layout is enough. A struct takes part by a member `template <class Stream> void fields(Stream& stream)` that hands
/// each of its fields to the stream: one list serves writing and reading.
namespace talus {

template <class T>
concept PlainNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class ByteWriter {
 public:
  const std::string& bytes() const { return bytes_; }

  template <class... Values>
  void operator()(Values&... values) {
    (write(values), ...);
  }

 private:
  template <PlainNumber T>
  void write(const T& number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  void write(std::string& text) {
    write(text.size());
    bytes_ += text;
  }
  void write(Vec3& vector) { bytes_.append(reinterpret_cast<const char*>(vector.data()), 3 * sizeof(double)); }
  template <class T, std::size_t N>
  void write(std::array<T, N>& values) {
    for (T& value : values) write(value);
  }
  template <class T>
  void write(std::vector<T>& values) {
    write(values.size());
    for (T& value : values) write(value);
  }
  template <class T>
  void write(std::optional<T>& value) {
    write(value.has_value());
    if (value) write(*value);
  }
  template <class T>
  requires std::is_class_v<T>
  void write(T& value) { value.fields(*this); }

  std::string bytes_;
};

/// What bytes a struct is written as, as a number that other fields make another one.
class ByteLayout {
 public:
  std::uint64_t hash() const { return hash_; }

  template <class... Values>
  void operator()(Values&... values) {
    (add(values), ...);
  }

 private:
  enum Kind : std::uint64_t { whole = 1, real, text, vector, array, list, optional, begin, end };

  void put(std::uint64_t what) { hash_ = hash_with(hash_, what); }
  template <class T>
  void put_one() {
    T one{};
    add(one);
  }
  template <PlainNumber T>
  void add(T&) {
    put(std::is_floating_point_v<T> ? real : whole);
    put(sizeof(T));
  }
  void add(std::string&) { put(text); }
  void add(Vec3&) { put(vector); }
  template <class T, std::size_t N>
  void add(std::array<T, N>&) {
    put(array);
    put(N);
    put_one<T>();
  }
  template <class T>
  void add(std::vector<T>&) {
    put(list);
    put_one<T>();
  }
  template <class T>
  void add(std::optional<T>&) {
    put(optional);
    put_one<T>();
  }
  template <class T>
  requires std::is_class_v<T>
  void add(T& value) {
    put(begin);
    value.fields(*this);
    put(end);
  }

  std::uint64_t hash_ = hash_of_nothing;
};

/// Throws std::runtime_error when the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }

 private:
  std::string_view take(std::size_t count) {
    if (count > rest_.size()) throw std::runtime_error("message of the mesher ends too early");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  template <PlainNumber T>
  void read(T& number) {
    std::memcpy(&number, take(sizeof number).data(), sizeof number);
  }
  std::size_t read_count() {
    std::size_t count = 0;
    read(count);
    if (count > rest_.size()) throw std::runtime_error("message of the mesher ends too early");
    return count;
  }
  void read(std::string& text) { text = take(read_count()); }
  void read(Vec3& vector) { std::memcpy(vector.data(), take(3 * sizeof(double)).data(), 3 * sizeof(double)); }
  template <class T, std::size_t N>
  void read(std::array<T, N>& values) {
    for (T& value : values) read(value);
  }
  template <class T>
  void read(std::vector<T>& values) {
    values.resize(read_count());
    for (T& value : values) read(value);
  }
  template <class T>
  void read(std::optional<T>& value) {
    bool present = false;
    read(present);
    if (present) read(value.emplace());
  }
  template <class T>
  requires std::is_class_v<T>
  void read(T& value) { value.fields(*this); }

  std::string_view rest_;
};

}  // namespace talus
