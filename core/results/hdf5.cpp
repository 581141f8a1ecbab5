#include "results/hdf5.hpp"

#include <algorithm>

#include "results/string_heap.hpp"

namespace talus::hdf5 {

namespace {

herr_t keep_description(unsigned depth, const H5E_error2_t* error, void* reason) {
  if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(reason) = error->desc;
  return 0;
}

Handle simple_space(hsize_t rows, hsize_t width, bool grows) {
  const hsize_t size[] = {rows, width};
  const hsize_t limit[] = {grows ? H5S_UNLIMITED : rows, width};
  return Handle(check(H5Screate_simple(width == 0 ? 1 : 2, size, limit), "cannot describe a data set"));
}

/// Rows and width of one that has one or two dimensions, as all of ours; the width of one is 0.
struct Extent {
  hsize_t rows = 0, width = 0;
};

Extent extent_of(hid_t dataset, const std::string& path) {
  const Handle space(check(H5Dget_space(dataset), "cannot read the size of " + path));
  const int dimensions = check(H5Sget_simple_extent_ndims(space), "cannot read the size of " + path);
  if (dimensions != 1 && dimensions != 2) throw Error(path + " is no table");
  hsize_t size[2] = {0, 0};
  check(H5Sget_simple_extent_dims(space, size, nullptr), "cannot read the size of " + path);
  return {size[0], size[1]};
}

/// An attribute that is one number or one text.
Handle open_attribute(hid_t object, const std::string& name) {
  Handle attribute(check(H5Aopen(object, name.c_str(), H5P_DEFAULT), "cannot open " + name));
  const Handle space(check(H5Aget_space(attribute), "cannot read " + name));
  if (check(H5Sget_simple_extent_npoints(space), "cannot read " + name) != 1) throw Error(name + " is not one value");
  return attribute;
}

/// The rows first … first + count of a dataset, selected.
Handle selected_rows(hid_t dataset, const std::string& path, hsize_t first, hsize_t count) {
  Handle space(check(H5Dget_space(dataset), "cannot read the size of " + path));
  const hsize_t start[] = {first, 0};
  const hsize_t selected[] = {count, extent_of(dataset, path).width};
  check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, selected, nullptr), "cannot select in " + path);
  return space;
}

Handle text_type() {
  Handle type(check(H5Tcopy(H5T_C_S1), "cannot describe a text"));
  check(H5Tset_size(type, H5T_VARIABLE), "cannot describe a text");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "cannot describe a text");
  return type;
}

}  // namespace

/// Files are closed where they are used. What HDF5 does at the end of the program to one that could not be written, as
/// the disk was full, crashes (1.10).
std::mutex& library_mutex() {
  static const bool nothing_at_exit = H5dont_atexit() >= 0;
  static_cast<void>(nothing_at_exit);
  static std::mutex mutex;
  return mutex;
}

void fail(const std::string& what) {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_description, &reason);
  const std::string begin = "error message = '";  // of the system, in a long list
  if (const auto at = reason.find(begin); at != std::string::npos) {
    reason = reason.substr(at + begin.size());
    throw Error(reason.substr(0, reason.find('\'')));
  }
  throw Error(reason.empty() ? what : what + " (" + reason + ")");
}

Handle::~Handle() {
  if (id_ < 0) return;
  switch (H5Iget_type(id_)) {
    case H5I_FILE:
      H5Fclose(id_);
      break;
    case H5I_GROUP:
      H5Gclose(id_);
      break;
    case H5I_DATASET:
      H5Dclose(id_);
      break;
    case H5I_DATASPACE:
      H5Sclose(id_);
      break;
    case H5I_DATATYPE:
      H5Tclose(id_);
      break;
    case H5I_ATTR:
      H5Aclose(id_);
      break;
    default:
      H5Pclose(id_);
      break;
  }
}

Handle create_group(hid_t parent, const std::string& path) {
  return Handle(check(H5Gcreate2(parent, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "cannot make " + path));
}

Handle open_dataset(hid_t parent, const std::string& path) {
  return Handle(check(H5Dopen2(parent, path.c_str(), H5P_DEFAULT), "cannot open " + path));
}

void write_fixed(hid_t parent, const std::string& path, hid_t type, const void* data, hsize_t rows, hsize_t width) {
  const Handle space = simple_space(rows, width, false);
  const Handle set(check(H5Dcreate2(parent, path.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         "cannot make " + path));
  if (rows > 0) check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "cannot write " + path);
  check(H5Dflush(set), "cannot write " + path);  // what only its closing would write is lost there without a word
}

void write_strings(hid_t parent, const std::string& path, const std::vector<std::string>& strings) {
  std::vector<const char*> texts(strings.size());
  std::ranges::transform(strings, texts.begin(), &std::string::c_str);
  write_fixed(parent, path, text_type(), texts.data(), texts.size(), 0);
}

template <class Number>
void write_attribute(hid_t object, const std::string& name, const std::vector<Number>& values) {
  const hsize_t size = values.size();
  const Handle space(
      check(size == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr), "cannot make " + name));
  const Handle attribute(check(H5Acreate2(object, name.c_str(), type_of<Number>(), space, H5P_DEFAULT, H5P_DEFAULT),
                               "cannot make " + name));
  check(H5Awrite(attribute, type_of<Number>(), values.data()), "cannot write " + name);
}
template void write_attribute(hid_t, const std::string&, const std::vector<double>&);
template void write_attribute(hid_t, const std::string&, const std::vector<std::int64_t>&);

void write_attribute(hid_t object, const std::string& name, const std::string& value) {
  // Of fixed length: VTK's reader understands no other for the attribute Type.
  const Handle type(check(H5Tcopy(H5T_C_S1), "cannot describe a text"));
  check(H5Tset_size(type, std::max<std::size_t>(value.size(), 1)), "cannot describe a text");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "cannot describe a text");
  const Handle space(check(H5Screate(H5S_SCALAR), "cannot make " + name));
  const Handle attribute(
      check(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), "cannot make " + name));
  check(H5Awrite(attribute, type, value.c_str()), "cannot write " + name);
}

namespace {

/// Of the whole file, which may grow while it is read.
hsize_t file_size(hid_t dataset, const std::string& path) {
  const Handle file(check(H5Iget_file_id(dataset), "cannot read the size of " + path));
  hsize_t size = 0;
  check(H5Fget_filesize(file, &size), "cannot read the size of " + path);
  return size;
}

/// Throws Error where `rows` of `bytes` each, packed behind each other at an address, would not be within the file.
void check_whole(hid_t dataset, const std::string& path, hsize_t rows, hsize_t bytes) {
  const hsize_t most = file_size(dataset, path), stored = H5Dget_storage_size(dataset);
  if (rows > most / bytes) throw Error(path + " is larger than the file");
  const haddr_t begin = H5Dget_offset(dataset);  // none where it stands in the header
  const bool within = begin == HADDR_UNDEF || (begin <= most && stored <= most - begin);
  if (stored < rows * bytes || !within) throw Error(path + " is not whole");
}

/// The same of the pieces that hold these rows. One that is not there at all is read as zeros.
void check_pieces(hid_t dataset, const std::string& path, hid_t layout, hsize_t first, hsize_t count, hsize_t bytes) {
  const Extent extent = extent_of(dataset, path);
  const hsize_t columns = extent.width == 0 ? 1 : extent.width, most = file_size(dataset, path);
  hsize_t piece[2] = {0, 1};
  const int dimensions = extent.width == 0 ? 1 : 2, filters = H5Pget_nfilters(layout);
  if (H5Pget_chunk(layout, 2, piece) != dimensions || piece[0] == 0 || piece[1] != columns)
    throw Error(path + " is laid out as nothing else");
  unsigned settings = 0;
  std::size_t none = 0;
  const bool checked = filters > 0;
  if (filters > 1 ||
      (checked && H5Pget_filter2(layout, 0, &settings, &none, nullptr, 0, nullptr, nullptr) != H5Z_FILTER_FLETCHER32))
    throw Error(path + " is packed, which it should not be");
  constexpr hsize_t checksum = 4;
  for (hsize_t row = first / piece[0] * piece[0]; row < first + count; row += piece[0]) {
    const hsize_t corner[] = {row, 0};
    unsigned skipped = 0;
    haddr_t address = HADDR_UNDEF;
    hsize_t stored = 0;
    check(H5Dget_chunk_info_by_coord(dataset, corner, &skipped, &address, &stored), "cannot read " + path);
    if (address == HADDR_UNDEF) continue;
    const bool within = address <= most && stored <= most - address && piece[0] <= most / (bytes * columns);
    if (!within) throw Error(path + " is larger than the file");
    if (skipped != 0 || stored != piece[0] * columns * bytes + (checked ? checksum : 0))
      throw Error(path + " is not whole");
  }
}

/// HDF5 (1.10) believes what a file says of the size and place of its numbers, and reads and writes beyond its memory
/// by it: that is held to the size of the file, and numbers to their kind, before it reads rows.
void check_rows(hid_t dataset, const std::string& path, hid_t type, hsize_t first, hsize_t count) {
  const Handle stored(check(H5Dget_type(dataset), "cannot read " + path));
  const H5T_class_t kind = H5Tget_class(type);
  const bool same = H5Tget_class(stored) == kind &&
                    (kind == H5T_COMPOUND || H5Tequal(stored, type) > 0 || H5Tequal(stored, H5T_NATIVE_FLOAT) > 0);
  if (!same) throw Error(path + " holds something else");
  const Handle layout(check(H5Dget_create_plist(dataset), "cannot read " + path));
  const hsize_t bytes = H5Tget_size(stored);
  const H5D_layout_t kind_of_layout = H5Pget_layout(layout);
  if (kind_of_layout == H5D_CHUNKED) return check_pieces(dataset, path, layout, first, count, bytes);
  if (kind_of_layout != H5D_CONTIGUOUS && kind_of_layout != H5D_COMPACT) throw Error(path + " lies elsewhere");
  const Extent extent = extent_of(dataset, path);
  check_whole(dataset, path, extent.rows, bytes * std::max<hsize_t>(extent.width, 1));
}

}  // namespace

std::size_t stored_count(hid_t dataset, const std::string& path) {
  const Extent extent = extent_of(dataset, path);
  const hsize_t most = file_size(dataset, path), width = std::max<hsize_t>(extent.width, 1);
  if (extent.rows > most / width) throw Error(path + " is larger than the file");
  return extent.rows * width;
}

void read_rows(hid_t dataset, const std::string& path, hid_t type, void* data, hsize_t first, hsize_t count) {
  if (count == 0) return;
  check_rows(dataset, path, type, first, count);
  const Handle file_space = selected_rows(dataset, path, first, count);
  const auto selected = static_cast<hsize_t>(check(H5Sget_select_npoints(file_space), "cannot select in " + path));
  const Handle memory_space = simple_space(selected, 0, false);
  check(H5Dread(dataset, type, memory_space, file_space, H5P_DEFAULT, data), "cannot read " + path);
}

template <class Number>
std::vector<Number> read_all(hid_t parent, const std::string& path) {
  const Handle set = open_dataset(parent, path);
  std::vector<Number> data(stored_count(set, path));
  read_rows(set, path, type_of<Number>(), data.data(), 0, extent_of(set, path).rows);
  return data;
}
template std::vector<double> read_all(hid_t, const std::string&);
template std::vector<std::uint8_t> read_all(hid_t, const std::string&);
template std::vector<std::int32_t> read_all(hid_t, const std::string&);
template std::vector<std::int64_t> read_all(hid_t, const std::string&);

std::vector<std::string> read_strings(hid_t parent, const std::string& path) {
  const Handle set = open_dataset(parent, path);
  const std::size_t count = stored_count(set, path);
  return count == 0 ? std::vector<std::string>() : strings_in_heap(set, path, count);
}

std::string read_text_attribute(hid_t object, const std::string& name) {
  const Handle attribute = open_attribute(object, name);
  const Handle type(check(H5Aget_type(attribute), "cannot read " + name));
  constexpr std::size_t longest = 1 << 16;  // of what fits into the header of an object
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || H5Tget_size(type) > longest)
    throw Error(name + " is no text");
  std::string text(H5Tget_size(type), '\0');
  check(H5Aread(attribute, type, text.data()), "cannot read " + name);
  while (!text.empty() && text.back() == '\0') text.pop_back();
  return text;
}

template <class Number>
Number read_number_attribute(hid_t object, const std::string& name) {
  const Handle attribute = open_attribute(object, name);
  const Handle type(check(H5Aget_type(attribute), "cannot read " + name));
  if (H5Tequal(type, type_of<Number>()) <= 0) throw Error(name + " is no number");
  Number number{};
  check(H5Aread(attribute, type_of<Number>(), &number), "cannot read " + name);
  return number;
}
template double read_number_attribute(hid_t, const std::string&);
template std::int64_t read_number_attribute(hid_t, const std::string&);

void Table::create(hid_t parent, const std::string& path, hid_t type, hsize_t width, hsize_t chunk_rows) {
  const Handle space = simple_space(0, width, true);
  const Handle layout(check(H5Pcreate(H5P_DATASET_CREATE), "cannot lay out " + path));
  const hsize_t chunk[] = {std::max<hsize_t>(chunk_rows, 1), width};
  check(H5Pset_chunk(layout, width == 0 ? 1 : 2, chunk), "cannot lay out " + path);
  const Handle set(
      check(H5Dcreate2(parent, path.c_str(), type, space, H5P_DEFAULT, layout, H5P_DEFAULT), "cannot make " + path));
}

void insert_field(hid_t type, const char* name, std::size_t offset, hid_t number, hsize_t count) {
  const std::string what = std::string("cannot describe ") + name;
  if (count == 1) {
    check(H5Tinsert(type, name, offset, number), what);
  } else {
    const Handle array(check(H5Tarray_create2(number, 1, &count), what));
    check(H5Tinsert(type, name, offset, array), what);
  }
}

Table::Table(hid_t parent, const std::string& path, hid_t type, hsize_t width)
    : path_(path), dataset_(open_dataset(parent, path)), type_(type), width_(width) {
  refresh();
}

void Table::refresh() {
  check(H5Drefresh(dataset_), "cannot open " + path_);
  const Extent extent = extent_of(dataset_, path_);
  if (extent.width != width_) throw Error(path_ + " has not the columns that it should");
  rows_ = extent_ = extent.rows;
}

void Table::go_back_to(hsize_t rows) {
  if (rows > extent_) throw Error(path_ + " has fewer rows than it should");
  rows_ = rows;
}

void Table::append(const void* data, hsize_t rows) {
  if (rows == 0) return;
  extent_ = std::max(extent_, rows_ + rows);
  const hsize_t size[] = {extent_, width_};
  check(H5Dset_extent(dataset_, size), "cannot extend " + path_);
  const Handle file_space = selected_rows(dataset_, path_, rows_, rows);
  const Handle memory_space = simple_space(rows, width_, false);
  check(H5Dwrite(dataset_, type_, memory_space, file_space, H5P_DEFAULT, data), "cannot write " + path_);
  rows_ += rows;
}

void Table::read(void* data, hsize_t first, hsize_t count) const {
  read_rows(dataset_, path_, type_, data, first, count);
}

}  // namespace talus::hdf5
