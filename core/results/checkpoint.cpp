#include "results/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <mutex>
#include <optional>
#include <tuple>

#include "base/error.hpp"
#include "results/folder.hpp"
#include "results/hdf5.hpp"
#include "results/superblock.hpp"

namespace talus {

namespace fs = std::filesystem;
using hdf5::check;
using hdf5::Handle;

namespace {

constexpr hsize_t largest_piece = 1 << 20;  // bytes of which a checksum is kept

/// The state in the file, which grows. With checksums: a disk may lose bits.
class StateSet {
 public:
  /// `piece`: bytes that the first piece has.
  StateSet(hid_t file, hsize_t piece) {
    const hsize_t none = 0, any = H5S_UNLIMITED, chunk = std::clamp<hsize_t>(piece, 1, largest_piece);
    const Handle space(check(H5Screate_simple(1, &none, &any), "cannot describe the state"));
    const Handle layout(check(H5Pcreate(H5P_DATASET_CREATE), "cannot lay out the state"));
    check(H5Pset_chunk(layout, 1, &chunk), "cannot lay out the state");
    check(H5Pset_fletcher32(layout), "cannot lay out the state");
    set_ = Handle(check(H5Dcreate2(file, "state", H5T_NATIVE_UINT8, space, H5P_DEFAULT, layout, H5P_DEFAULT),
                        "cannot make the state"));
  }

  void append(std::string_view bytes) {
    const hsize_t first = size_, count = bytes.size();
    size_ += count;
    check(H5Dset_extent(set_, &size_), "cannot be written");
    const Handle there(check(H5Dget_space(set_), "cannot describe the state"));
    check(H5Sselect_hyperslab(there, H5S_SELECT_SET, &first, nullptr, &count, nullptr), "cannot describe the state");
    const Handle here(check(H5Screate_simple(1, &count, nullptr), "cannot describe the state"));
    check(H5Dwrite(set_, H5T_NATIVE_UINT8, here, there, H5P_DEFAULT, bytes.data()), "cannot be written");
  }

  void flush() { check(H5Dflush(set_), "cannot be written"); }

 private:
  Handle set_;
  hsize_t size_ = 0;
};

void write_state(hid_t file, const StateSource& state) {
  std::optional<StateSet> set;
  state([&](std::string_view bytes) {
    if (!set) set.emplace(file, bytes.size());
    set->append(bytes);
  });
  if (!set) set.emplace(file, 1);
  set->flush();
}

std::string read_state(hid_t file) {
  const Handle set = hdf5::open_dataset(file, "state");
  std::string bytes(hdf5::stored_count(set, "state"), '\0');
  hdf5::read_rows(set, "state", H5T_NATIVE_UINT8, bytes.data(), 0, bytes.size());
  return bytes;
}

CheckpointLabel read_label(hid_t file) {
  const std::vector<std::string> version = hdf5::read_strings(file, "version");
  const std::vector<std::string> project = hdf5::read_strings(file, "project");
  const std::vector<double> time = hdf5::read_all<double>(file, "time");
  if (version.size() != 1 || project.size() != 1 || time.size() != 1) throw hdf5::Error("its label is not whole");
  return {version.front(), project.front(), time.front()};
}

/// Of the newest format all that HDF5 keeps of a file's parts has checksums. Of others it believes what it finds, such
/// as pieces without a size, by which it divides.
void require_newest_format(const fs::path& path) {
  std::array<char, std::tuple_size_v<Superblock>> bytes{};
  std::ifstream(path, std::ios::binary).read(bytes.data(), bytes.size());
  if (!begins_as_superblock(bytes.data(), bytes.size())) throw hdf5::Error("it does not begin as one");
}

/// What `part` reads of the file.
template <class Part>
auto read(const fs::path& path, const Part& part) -> std::optional<decltype(part(hid_t{}))> {
  if (!fs::exists(path)) return std::nullopt;
  const std::lock_guard lock(hdf5::library_mutex());
  try {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // reasons go into exceptions, not onto the terminal
    require_newest_format(path);
    const Handle file(check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "cannot be opened"));
    return part(file);
  } catch (const hdf5::Error& error) {
    throw InputError(path.string(), std::string("is no checkpoint, or damaged: ") + error.what(),
                     "run the project without --resume");
  }
}

void write_whole(const fs::path& path, const CheckpointLabel& label, const StateSource& state) {
  const Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "cannot be made"));
  check(H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST), "cannot be made");
  Handle file(check(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), "cannot be made"));
  hdf5::write_strings(file, "version", {label.version});
  hdf5::write_strings(file, "project", {label.project_text});
  hdf5::write_fixed(file, "time", std::vector<double>{label.time});
  write_state(file, state);
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "cannot be written");
}

}  // namespace

void write_checkpoint(const fs::path& file, const CheckpointLabel& label, const StateSource& state) {
  const fs::path fresh = file.string() + ".new";
  try {
    const std::lock_guard lock(hdf5::library_mutex());
    write_whole(fresh, label, state);
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
