#pragma once

#include <array>
#include <concepts>
#include <cstring>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// Writes down the state of objects, to the last bit, or reads it back: a class lists what it remembers once, in
/// `archive(auto& state)`, for both. The bytes are this machine's and this program's: where a list changes, so do they.
class StateArchive {
 public:
  /// Where what is written goes, piece by piece, in order.
  using Sink = std::function<void(std::string_view)>;
  static constexpr std::size_t piece = 1 << 20;  ///< bytes, of all pieces but the last

  /// Writes.
  StateArchive() = default;
  /// Writes, and keeps no more than a piece: a state may be as large as all else that a run holds. pass_on() ends it.
  explicit StateArchive(Sink sink) : sink_(std::move(sink)) {}
  /// Reads what another has written; `bytes` outlive it.
  explicit StateArchive(std::string_view bytes) : reads_(true), left_(bytes) {}

  bool reads() const { return reads_; }
  bool all_read() const { return left_.empty(); }
  const std::string& bytes() const { return bytes_; }  ///< written so far, and not passed on

  /// Gives the sink what it has not got yet.
  void pass_on() {
    if (!bytes_.empty()) sink_(bytes_);
    bytes_.clear();
  }

  /// Throws std::runtime_error where less is left to read than a value takes.
  template <class... Values>
  void operator()(Values&... values) {
    (exchange(values), ...);
  }

 private:
  template <class T>
  static constexpr bool is_plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;
  template <class T>
  static constexpr bool is_matrix = std::is_base_of_v<Eigen::DenseBase<T>, T>;

  void exchange_bytes(void* data, std::size_t size) {
    if (!reads_) return write({static_cast<const char*>(data), size});
    if (size > left_.size()) throw std::runtime_error("the state of the run ends too early");
    if (size > 0) std::memcpy(data, left_.data(), size);
    left_.remove_prefix(size);
  }

  void write(std::string_view bytes) {
    while (sink_ && bytes_.size() + bytes.size() >= piece) {
      const std::size_t part = piece - bytes_.size();
      bytes_.append(bytes.substr(0, part));
      bytes.remove_prefix(part);
      pass_on();
    }
    bytes_.append(bytes);
  }

  /// That of a list, of which each entry takes a byte at least.
  std::size_t exchange_size(std::size_t size) {
    exchange_bytes(&size, sizeof size);
    if (reads_ && size > left_.size()) throw std::runtime_error("the state of the run is damaged");
    return size;
  }

  template <class T>
  void exchange(T& value) {
    if constexpr (is_plain<T>) {
      exchange_bytes(&value, sizeof value);
    } else if constexpr (is_matrix<T>) {
      exchange_matrix(value);
    } else {
      value.archive(*this);
    }
  }

  template <class Matrix>
  void exchange_matrix(Matrix& matrix) {
    if constexpr (Matrix::SizeAtCompileTime == Eigen::Dynamic) {
      const auto rows = static_cast<Eigen::Index>(exchange_size(static_cast<std::size_t>(matrix.rows())));
      const auto columns = static_cast<Eigen::Index>(exchange_size(static_cast<std::size_t>(matrix.cols())));
      matrix.resize(rows, columns);
    }
    exchange_bytes(matrix.data(), sizeof(double) * static_cast<std::size_t>(matrix.size()));
  }

  template <class T>
  void exchange(std::vector<T>& values) {
    values.resize(exchange_size(values.size()));
    if constexpr (is_plain<T>)
      exchange_bytes(values.data(), sizeof(T) * values.size());
    else
      for (T& value : values) exchange(value);
  }

  void exchange(std::vector<bool>& flags) {
    flags.resize(exchange_size(flags.size()));
    for (std::size_t i = 0; i < flags.size(); ++i) {
      bool flag = flags[i];
      exchange(flag);
      flags[i] = flag;
    }
  }

  void exchange(std::string& text) {
    text.resize(exchange_size(text.size()));
    exchange_bytes(text.data(), text.size());
  }

  template <class T, std::size_t N>
  void exchange(std::array<T, N>& values) {
    for (T& value : values) exchange(value);
  }
  template <class T, std::size_t N>
  void exchange(T (&values)[N]) {
    for (T& value : values) exchange(value);
  }

  template <class A, class B>
  void exchange(std::pair<A, B>& pair) {
    exchange(pair.first);
    exchange(pair.second);
  }

  template <class T>
  void exchange(std::optional<T>& value) {
    bool is_there = value.has_value();
    exchange(is_there);
    if (reads_) value.reset();
    if (reads_ && is_there) value.emplace();
    if (value) exchange(*value);
  }

  template <class Key, class Value>
  void exchange(std::map<Key, Value>& map) {
    std::size_t size = exchange_size(map.size());
    if (!reads_) {
      for (auto& [key, value] : map) {
        Key copy = key;
        exchange(copy);
        exchange(value);
      }
      return;
    }
    map.clear();
    for (; size > 0; --size) {
      Key key{};
      exchange(key);
      exchange(map[key]);
    }
  }

  bool reads_ = false;
  Sink sink_;
  std::string bytes_;
  std::string_view left_;
};

}  // namespace talus
