#pragma once

#include <hdf5.h>

#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// The little of HDF5's C interface that results.h5 needs, with errors as exceptions and identifiers that close.
/// Seen by this folder's .cpp files alone.
namespace talus::hdf5 {

/// Says what could not be done and HDF5's own reason.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Debian's HDF5 is not thread-safe: the solving thread writes while the window reads. Whoever calls it holds this.
std::mutex& library_mutex();

/// Throws Error with HDF5's innermost reason.
[[noreturn]] void fail(const std::string& what);

template <class Status>
Status check(Status status, const std::string& what) {
  if (status < 0) fail(what);
  return status;
}

/// An identifier that is closed with the call that fits its kind.
class Handle {
 public:
  Handle() = default;
  explicit Handle(hid_t id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle();
  operator hid_t() const { return id_; }

 private:
  hid_t id_ = H5I_INVALID_HID;
};

template <class Number>
hid_t type_of() {
  if constexpr (std::is_same_v<Number, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<Number, float>) return H5T_NATIVE_FLOAT;
  if constexpr (std::is_same_v<Number, std::int32_t>) return H5T_NATIVE_INT32;
  if constexpr (std::is_same_v<Number, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<Number, std::uint8_t>) return H5T_NATIVE_UINT8;
}

Handle create_group(hid_t parent, const std::string& path);
Handle open_dataset(hid_t parent, const std::string& path);

/// A dataset of rows × `width` numbers; `width` 0 makes it one-dimensional.
void write_fixed(hid_t parent, const std::string& path, hid_t type, const void* data, hsize_t rows, hsize_t width);
template <class Number>
void write_fixed(hid_t parent, const std::string& path, const std::vector<Number>& data, hsize_t width = 0) {
  write_fixed(parent, path, type_of<Number>(), data.data(), data.size() / (width == 0 ? 1 : width), width);
}
void write_strings(hid_t parent, const std::string& path, const std::vector<std::string>& strings);

template <class Number>
void write_attribute(hid_t object, const std::string& name, const std::vector<Number>& values);
void write_attribute(hid_t object, const std::string& name, const std::string& value);

/// How many numbers to make room for. Throws Error where they would be more than the file has bytes: none is packed.
std::size_t stored_count(hid_t dataset, const std::string& path);
/// Throws Error also where the file says what cannot be of the size, place or kind of these rows.
void read_rows(hid_t dataset, const std::string& path, hid_t type, void* data, hsize_t first, hsize_t count);
template <class Number>
std::vector<Number> read_all(hid_t parent, const std::string& path);
std::vector<std::string> read_strings(hid_t parent, const std::string& path);
std::string read_text_attribute(hid_t object, const std::string& name);
template <class Number>
Number read_number_attribute(hid_t object, const std::string& name);

/// A field of a compound type: `count` numbers at `offset` of the row.
void insert_field(hid_t type, const char* name, std::size_t offset, hid_t number, hsize_t count);

/// A dataset that grows by rows.
class Table {
 public:
  Table() = default;
  /// Creates an empty one, stored in pieces of `chunk_rows` rows; `width` 0 makes it one-dimensional.
  static void create(hid_t parent, const std::string& path, hid_t type, hsize_t width, hsize_t chunk_rows);
  /// Opens one of that width; `type` is that of the rows' numbers in memory and outlives the table.
  Table(hid_t parent, const std::string& path, hid_t type, hsize_t width = 0);

  /// What this process has read before may be out of date where another one writes. No other handle of this process
  /// may have the dataset open.
  void refresh();
  void append(const void* data, hsize_t rows);
  /// What is appended from now on follows so many rows, and is written over those behind. Throws Error where there are
  /// fewer.
  void go_back_to(hsize_t rows);
  void read(void* data, hsize_t first, hsize_t count) const;
  hsize_t rows() const { return rows_; }

 private:
  std::string path_;
  Handle dataset_;
  hid_t type_ = H5I_INVALID_HID;
  hsize_t rows_ = 0, width_ = 0;
  hsize_t extent_ = 0;  // rows that there are, those to be written over among them
};

}  // namespace talus::hdf5
