#include "results/string_heap.hpp"

#include <cstring>
#include <fstream>
#include <map>

namespace talus::hdf5 {

namespace {

// HDF5 File Format Specification 3.0, III.E (global heap) and IV.A.2.d (variable-length data), little-endian.
constexpr std::size_t reference_size = 16, heap_header_size = 16, piece_header_size = 16;

template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, &bytes[at], sizeof number);
  return number;
}

class FileBytes {
 public:
  explicit FileBytes(hid_t object) {
    std::string name(static_cast<std::size_t>(check(H5Fget_name(object, nullptr, 0), "has no name")) + 1, '\0');
    check(H5Fget_name(object, name.data(), name.size()), "has no name");
    stream_.open(name.c_str(), std::ios::binary | std::ios::ate);
    size_ = stream_ ? static_cast<std::uint64_t>(stream_.tellg()) : 0;
  }

  std::string read(std::uint64_t begin, std::uint64_t size) {
    if (begin > size_ || size > size_ - begin) throw Error("a text lies behind the file's end");
    std::string bytes(size, '\0');
    stream_.seekg(static_cast<std::streamoff>(begin));
    if (!stream_.read(bytes.data(), static_cast<std::streamsize>(size))) throw Error("a text cannot be read");
    return bytes;
  }

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

/// The texts of a heap by their numbers.
using Heap = std::map<std::uint16_t, std::string>;

Heap heap_at(FileBytes& file, std::uint64_t address) {
  const std::string header = file.read(address, heap_header_size);
  if (!header.starts_with("GCOL\1")) throw Error("a heap of texts is not there");
  const std::string bytes = file.read(address, number_at<std::uint64_t>(header, 8));
  Heap heap;
  for (std::size_t at = heap_header_size; at + piece_header_size <= bytes.size();) {
    const auto number = number_at<std::uint16_t>(bytes, at);
    const auto size = number_at<std::uint64_t>(bytes, at + 8), left = std::uint64_t{bytes.size() - at};
    if (number == 0) {  // what is free, to the end
      if (size != left) throw Error("a heap of texts is damaged");
      break;
    }
    const bool fits = size <= left && piece_header_size + (size + 7) / 8 * 8 <= left;
    if (!fits || !heap.emplace(number, bytes.substr(at + piece_header_size, size)).second)
      throw Error("a heap of texts is damaged");
    at += piece_header_size + (size + 7) / 8 * 8;
  }
  return heap;
}

}  // namespace

std::vector<std::string> strings_in_heap(hid_t dataset, const std::string& path, std::size_t count) {
  const Handle type(check(H5Dget_type(dataset), "cannot read " + path));
  const haddr_t begin = H5Dget_offset(dataset);
  if (H5Tis_variable_str(type) <= 0 || begin == HADDR_UNDEF) throw Error(path + " holds no texts");
  FileBytes file(dataset);
  const std::string references = file.read(begin, count * reference_size);
  std::map<std::uint64_t, Heap> heaps;
  std::vector<std::string> strings(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * reference_size;
    const auto length = number_at<std::uint32_t>(references, at), piece = number_at<std::uint32_t>(references, at + 12);
    const auto address = number_at<std::uint64_t>(references, at + 4);
    if (address == 0) continue;  // none
    if (!heaps.contains(address)) heaps[address] = heap_at(file, address);
    const auto found = heaps[address].find(static_cast<std::uint16_t>(piece));
    if (piece > UINT16_MAX || found == heaps[address].end() || found->second.size() != length)
      throw Error("a text of " + path + " is not there");
    strings[i] = found->second.substr(0, found->second.find('\0'));
  }
  return strings;
}

}  // namespace talus::hdf5
