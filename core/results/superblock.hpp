#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace talus {

/// What an HDF5 file begins with (File Format Specification 3.0, II.A: version 3 with eight-byte addresses): whether a
/// writer has it open, where it ends, and a checksum.
using Superblock = std::array<unsigned char, 48>;

/// Whether bytes that a file has at its beginning hold one of that kind.
bool begins_as_superblock(const void* bytes, std::size_t size);
/// The superblock that `bytes` begin with, of a file that nobody has open, and that ends there.
Superblock closed(const void* bytes, std::uint64_t end);

/// Marks an HDF5 file as closed and its end as the end of the file, as h5clear would: what a run of an earlier version
/// left marked as open when it was killed.
/// Throws std::runtime_error when the file has another superblock, WriteError when it cannot be written.
void mark_closed(const std::filesystem::path& file);

/// Whether the file says that a writer has it open, as a kill may leave it. Throws as `mark_closed`.
bool is_marked_open(const std::filesystem::path& file);

}  // namespace talus
