#include "results/superblock.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "results/folder.hpp"

namespace talus {

namespace {

constexpr std::array<unsigned char, 11> beginning = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n', 3, 8, 8};
constexpr std::size_t flags_at = 11, end_of_file_at = 28, checksum_at = 44;

Superblock read_superblock(std::istream& stream, const std::filesystem::path& file) {
  Superblock block;
  if (!stream.read(reinterpret_cast<char*>(block.data()), block.size()) ||
      !begins_as_superblock(block.data(), block.size()))
    throw std::runtime_error(file.string() + ": has not the superblock that results.h5 begins with");
  return block;
}

/// Bob Jenkins's lookup3 (public domain), which the specification names for its checksums, of 44 bytes.
std::uint32_t lookup3(const Superblock& bytes) {
  std::array<std::uint32_t, checksum_at / 4> words;
  std::memcpy(words.data(), bytes.data(), checksum_at);
  std::uint32_t a = 0xdeadbeef + checksum_at, b = a, c = a;
  std::size_t i = 0;
  for (; i + 3 < words.size(); i += 3) {
    a += words[i], b += words[i + 1], c += words[i + 2];
    a -= c, a ^= std::rotl(c, 4), c += b;
    b -= a, b ^= std::rotl(a, 6), a += c;
    c -= b, c ^= std::rotl(b, 8), b += a;
    a -= c, a ^= std::rotl(c, 16), c += b;
    b -= a, b ^= std::rotl(a, 19), a += c;
    c -= b, c ^= std::rotl(b, 4), b += a;
  }
  a += words[i], b += words[i + 1];
  c ^= b, c -= std::rotl(b, 14);
  a ^= c, a -= std::rotl(c, 11);
  b ^= a, b -= std::rotl(a, 25);
  c ^= b, c -= std::rotl(b, 16);
  a ^= c, a -= std::rotl(c, 4);
  b ^= a, b -= std::rotl(a, 14);
  c ^= b, c -= std::rotl(b, 24);
  return c;
}

}  // namespace

bool begins_as_superblock(const void* bytes, std::size_t size) {
  return size >= std::tuple_size_v<Superblock> && std::memcmp(bytes, beginning.data(), beginning.size()) == 0;
}

Superblock closed(const void* bytes, std::uint64_t end) {
  static_assert(std::endian::native == std::endian::little);
  Superblock block;
  std::memcpy(block.data(), bytes, block.size());
  block[flags_at] = 0;
  std::memcpy(&block[end_of_file_at], &end, sizeof end);
  const std::uint32_t checksum = lookup3(block);
  std::memcpy(&block[checksum_at], &checksum, sizeof checksum);
  return block;
}

void mark_closed(const std::filesystem::path& file) {
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  const Superblock block = closed(read_superblock(stream, file).data(), std::filesystem::file_size(file));
  stream.seekp(0);
  stream.write(reinterpret_cast<const char*>(block.data()), block.size());
  if (!stream.flush()) throw WriteError(file);
}

bool is_marked_open(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return read_superblock(stream, file)[flags_at] != 0;
}

}  // namespace talus
