#pragma once

#include <filesystem>

namespace talus {

/// Marks an HDF5 file (superblock version 3) as closed and its end as the end of the file, as h5clear would, so that
/// programs that know nothing of a writer, such as ParaView, open it during the run and after a kill.
/// Throws std::runtime_error when the file has another superblock, WriteError when it cannot be written.
void mark_closed(const std::filesystem::path& file);

/// Whether the file says that a writer has it open, as a kill may leave it. Throws as `mark_closed`.
bool is_marked_open(const std::filesystem::path& file);

}  // namespace talus
