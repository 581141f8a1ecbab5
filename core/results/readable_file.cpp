#include "results/readable_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

#include "results/superblock.hpp"

namespace talus::hdf5 {

namespace {

constexpr haddr_t largest_address = static_cast<haddr_t>(1) << 62;
constexpr herr_t good = 0, bad = -1;

using Clock = std::chrono::steady_clock;

/// HDF5 knows the part that it keeps itself, and hands it back.
struct OpenFile {
  H5FD_t of_library{};
  int descriptor = -1;
  haddr_t end_of_room = 0;  ///< that HDF5 has given away
  haddr_t length = 0;       ///< of the file
  haddr_t told_length = 0;  ///< that the superblock names: the file has had it for a while
  Clock::time_point grew{};
  dev_t device = 0;
  ino_t number = 0;
};

OpenFile& our(H5FD_t* file) { return *reinterpret_cast<OpenFile*>(file); }
const OpenFile& our(const H5FD_t* file) { return *reinterpret_cast<const OpenFile*>(file); }

/// All of it, for a call may do less.
bool transfer(auto call, int descriptor, auto* bytes, std::size_t size, haddr_t at) {
  while (size > 0) {
    const ssize_t done = call(descriptor, bytes, size, static_cast<off_t>(at));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes += done;
    size -= static_cast<std::size_t>(done);
    at += static_cast<haddr_t>(done);
  }
  return true;
}

/// Why the system has refused, as HDF5's usual driver says it.
void tell_reason() {
  const std::string reason = "error message = '" + std::generic_category().message(errno) + "'";
  H5Epush2(H5E_DEFAULT, __FILE__, __func__, __LINE__, H5E_ERR_CLS, H5E_IO, H5E_WRITEERROR, "%s", reason.c_str());
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t, haddr_t) {
  int how = (flags & H5F_ACC_RDWR) != 0 ? O_RDWR : O_RDONLY;
  if ((flags & H5F_ACC_CREAT) != 0) how |= O_CREAT;
  if ((flags & H5F_ACC_TRUNC) != 0) how |= O_TRUNC;
  if ((flags & H5F_ACC_EXCL) != 0) how |= O_EXCL;
  auto file = std::make_unique<OpenFile>();
  file->descriptor = ::open(name, how | O_CLOEXEC, 0666);
  struct stat about {};
  if (file->descriptor < 0 || fstat(file->descriptor, &about) != 0) {
    tell_reason();
    if (file->descriptor >= 0) ::close(file->descriptor);
    return nullptr;
  }
  file->length = static_cast<haddr_t>(about.st_size);
  file->device = about.st_dev;
  file->number = about.st_ino;
  return reinterpret_cast<H5FD_t*>(file.release());
}

/// Makes the file longer than what was given away, by a tenth and at least 32 MB: readers that have just looked find
/// within that what comes next. Who opens it asks for its length first and reads the superblock then: that tells of a
/// new length only when readers have had the time for it. True where the file is as long.
bool keep_longer(OpenFile& file) {
  constexpr haddr_t least = haddr_t{32} << 20, part = 10;
  constexpr std::chrono::milliseconds a_while{200};
  const haddr_t spare = std::max(least, file.end_of_room / part);
  const Clock::time_point now = Clock::now();
  if (now - file.grew > a_while || file.told_length < file.end_of_room) file.told_length = file.length;
  if (file.length >= file.end_of_room + spare / 2) return true;
  if (ftruncate(file.descriptor, static_cast<off_t>(file.end_of_room + spare)) != 0) return false;
  file.length = file.end_of_room + spare;
  file.grew = now;
  if (file.told_length < file.end_of_room) file.told_length = file.length;
  return true;
}

bool write_superblock(OpenFile& file, const void* bytes, haddr_t end) {
  const Superblock block = closed(bytes, end);
  return transfer(pwrite, file.descriptor, reinterpret_cast<const char*>(block.data()), block.size(), 0);
}

/// The superblock first: no reader may find one that names more than there is.
bool cut_to_size(OpenFile& file) {
  Superblock block;
  if (!transfer(pread, file.descriptor, reinterpret_cast<char*>(block.data()), block.size(), 0)) return false;
  if (!begins_as_superblock(block.data(), block.size())) return true;
  return write_superblock(file, block.data(), file.end_of_room) &&
         ftruncate(file.descriptor, static_cast<off_t>(file.end_of_room)) == 0;
}

bool may_write(const OpenFile& file) { return (fcntl(file.descriptor, F_GETFL) & O_ACCMODE) == O_RDWR; }

herr_t close_file(H5FD_t* file) {
  const std::unique_ptr<OpenFile> closing(&our(file));
  const bool done = !may_write(*closing) || cut_to_size(*closing);
  return ::close(closing->descriptor) == 0 && done ? good : bad;
}

int compare(const H5FD_t* a, const H5FD_t* b) {
  const auto key = [](const OpenFile& file) { return std::pair(file.device, file.number); };
  return key(our(a)) < key(our(b)) ? -1 : key(our(b)) < key(our(a)) ? 1 : 0;
}

/// As HDF5's usual driver, whose files these are.
herr_t tell_features(const H5FD_t*, unsigned long* features) {
  *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
              H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_POSIX_COMPAT_HANDLE | H5FD_FEAT_SUPPORTS_SWMR_IO |
              H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return good;
}

haddr_t end_of_room(const H5FD_t* file, H5FD_mem_t) { return our(file).end_of_room; }

herr_t set_end_of_room(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  our(file).end_of_room = address;
  return good;
}

haddr_t length(const H5FD_t* file, H5FD_mem_t) { return our(file).length; }

herr_t get_handle(H5FD_t* file, hid_t, void** handle) {
  *handle = &our(file).descriptor;
  return good;
}

/// Past the end there are zeros, as HDF5 asks for.
herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, void* into) {
  const haddr_t there = our(file).length > at ? our(file).length - at : 0;
  const auto found = static_cast<std::size_t>(std::min<haddr_t>(size, there));
  std::memset(static_cast<char*>(into) + found, 0, size - found);
  return transfer(pread, our(file).descriptor, static_cast<char*>(into), found, at) ? good : bad;
}

herr_t write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, const void* from) {
  OpenFile& open = our(file);
  const bool as_superblock = at == 0 && begins_as_superblock(from, size);
  const std::size_t done = as_superblock ? std::tuple_size_v<Superblock> : 0;
  if (keep_longer(open) && (!as_superblock || write_superblock(open, from, open.told_length)) &&
      transfer(pwrite, open.descriptor, static_cast<const char*>(from) + done, size - done, at + done))
    return good;
  tell_reason();
  return bad;
}

herr_t nothing_to_do(H5FD_t*, hid_t, hbool_t) { return good; }

/// Readers that lock are not kept away, nor do they keep us away.
herr_t lock(H5FD_t*, hbool_t) { return good; }
herr_t unlock(H5FD_t*) { return good; }

hid_t driver() {
  static const hid_t registered = [] {
    H5FD_class_t readable{};
    readable.name = "talus_readable";
    readable.maxaddr = largest_address;
    readable.fc_degree = H5F_CLOSE_WEAK;
    readable.open = open_file;
    readable.close = close_file;
    readable.cmp = compare;
    readable.query = tell_features;
    readable.get_eoa = end_of_room;
    readable.set_eoa = set_end_of_room;
    readable.get_eof = length;
    readable.get_handle = get_handle;
    readable.read = read;
    readable.write = write;
    readable.flush = nothing_to_do;
    readable.truncate = nothing_to_do;
    readable.lock = lock;
    readable.unlock = unlock;
    constexpr H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(map), std::end(map), readable.fl_map);
    return H5FDregister(&readable);
  }();
  return registered;
}

}  // namespace

void write_readably(hid_t access) { check(H5Pset_driver(access, driver(), nullptr), "cannot be made"); }

}  // namespace talus::hdf5
