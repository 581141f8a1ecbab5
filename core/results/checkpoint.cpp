#include "results/checkpoint.hpp"

#include <algorithm>
#include <cstdint>
#include <mutex>

#include "base/error.hpp"
#include "results/folder.hpp"
#include "results/hdf5.hpp"

namespace talus {

namespace fs = std::filesystem;
using hdf5::check;
using hdf5::Handle;

namespace {

constexpr hsize_t largest_piece = 1 << 20;  // bytes of which a checksum is kept

/// With checksums: a disk may lose bits.
void write_state(hid_t file, const std::string& state) {
  const hsize_t size = state.size(), piece = std::clamp<hsize_t>(size, 1, largest_piece);
  const Handle space(check(H5Screate_simple(1, &size, nullptr), "cannot describe the state"));
  const Handle layout(check(H5Pcreate(H5P_DATASET_CREATE), "cannot lay out the state"));
  check(H5Pset_chunk(layout, 1, &piece), "cannot lay out the state");
  check(H5Pset_fletcher32(layout), "cannot lay out the state");
  const Handle set(check(H5Dcreate2(file, "state", H5T_NATIVE_UINT8, space, H5P_DEFAULT, layout, H5P_DEFAULT),
                         "cannot make the state"));
  check(H5Dwrite(set, H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, state.data()), "cannot be written");
  check(H5Dflush(set), "cannot be written");
}

std::string read_state(hid_t file) {
  const std::vector<std::uint8_t> bytes = hdf5::read_all<std::uint8_t>(file, "state");
  return {bytes.begin(), bytes.end()};
}

CheckpointLabel read_label(hid_t file) {
  const std::vector<std::string> version = hdf5::read_strings(file, "version");
  const std::vector<std::string> project = hdf5::read_strings(file, "project");
  const std::vector<double> time = hdf5::read_all<double>(file, "time");
  if (version.size() != 1 || project.size() != 1 || time.size() != 1) throw hdf5::Error("its label is not whole");
  return {version.front(), project.front(), time.front()};
}

/// What `part` reads of the file.
template <class Part>
auto read(const fs::path& path, const Part& part) -> std::optional<decltype(part(hid_t{}))> {
  if (!fs::exists(path)) return std::nullopt;
  const std::lock_guard lock(hdf5::library_mutex());
  try {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // reasons go into exceptions, not onto the terminal
    const Handle file(check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "cannot be opened"));
    return part(file);
  } catch (const hdf5::Error& error) {
    throw InputError(path.string(), std::string("is no checkpoint, or damaged: ") + error.what(),
                     "run the project without --resume");
  }
}

void write_whole(const fs::path& path, const Checkpoint& checkpoint) {
  Handle file(check(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), "cannot be made"));
  hdf5::write_strings(file, "version", {checkpoint.label.version});
  hdf5::write_strings(file, "project", {checkpoint.label.project_text});
  hdf5::write_fixed(file, "time", std::vector<double>{checkpoint.label.time});
  write_state(file, checkpoint.state);
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "cannot be written");
}

}  // namespace

void write_checkpoint(const fs::path& file, const Checkpoint& checkpoint) {
  const fs::path fresh = file.string() + ".new";
  try {
    const std::lock_guard lock(hdf5::library_mutex());
    write_whole(fresh, checkpoint);
  } catch (const hdf5::Error& error) {
    std::error_code ignored;  // it takes room on a disk that has none
    fs::remove(fresh, ignored);
    throw WriteError(fresh, error.what());
  }
  flush_to_disk(fresh);
  rename_file(fresh, file);
}

std::optional<Checkpoint> read_checkpoint(const fs::path& path) {
  return read(path, [](hid_t file) { return Checkpoint{read_label(file), read_state(file)}; });
}

std::optional<CheckpointLabel> read_checkpoint_label(const fs::path& path) { return read(path, read_label); }

}  // namespace talus
