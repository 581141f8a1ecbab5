#include "results/xdmf.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>

#include "base/xml_text.hpp"
#include "model/number_text.hpp"
#include "results/folder.hpp"
#include "results/hdf5.hpp"

namespace talus {

namespace {

const std::string closing_tags = "  </Grid>\n </Domain>\n</Xdmf>\n";
// A kill may tear a write between two pages of the system's file cache, never inside one.
constexpr std::uint64_t page = 4096;
// What stands behind the closing tags while they move: an instruction that no reader knows, which XML lets be there.
const std::string instruction_begin = "<?moving ", instruction = "<?moved ?>";

constexpr const char* integer64 = "NumberType=\"Int\" Precision=\"8\"";
constexpr const char* integer32 = "NumberType=\"Int\" Precision=\"4\"";
constexpr const char* float64 = "NumberType=\"Float\" Precision=\"8\"";
constexpr const char* float32 = "NumberType=\"Float\" Precision=\"4\"";

/// A whole one-dimensional dataset of results.h5.
std::string column(std::uint64_t rows, const std::string& type, const std::string& dataset) {
  return "<DataItem Dimensions=\"" + std::to_string(rows) + "\" " + type + " Format=\"HDF\">results.h5:" + dataset +
         "</DataItem>";
}

/// A whole one-dimensional dataset of results.h5, as the slab that VTK's reader asks for in a moving grid: it would
/// take an unwrapped topology for a sign that the geometry is cached too, and complain that it is not.
std::string wrapped_column(std::uint64_t rows, const std::string& type, const std::string& dataset) {
  const std::string size = std::to_string(rows);
  return "<DataItem ItemType=\"HyperSlab\" Dimensions=\"" + size +
         "\"><DataItem Dimensions=\"3 1\" Format=\"XML\">0 1 " + size + "</DataItem>" + column(rows, type, dataset) +
         "</DataItem>";
}

/// The rows of one frame in a dataset that holds `rows` × `width` numbers for each.
std::string rows_of_frame(std::uint64_t frame, std::uint64_t rows, std::uint64_t width, const std::string& type,
                          const std::string& dataset) {
  const std::string columns = std::to_string(width), size = std::to_string(rows) + ' ' + columns;
  const std::string start_stride_count = std::to_string(frame * rows) + " 0 1 1 " + size;
  return "<DataItem ItemType=\"HyperSlab\" Dimensions=\"" + size + "\">" +
         "<DataItem Dimensions=\"3 2\" Format=\"XML\">" + start_stride_count + "</DataItem>" +
         "<DataItem Dimensions=\"" + std::to_string((frame + 1) * rows) + ' ' + columns + "\" " + type +
         " Format=\"HDF\">results.h5:" + dataset + "</DataItem></DataItem>";
}

/// A whole dataset.
std::string whole_table(std::uint64_t rows, std::uint64_t width, const char* type, const std::string& place) {
  return "<DataItem Dimensions=\"" + std::to_string(rows) + ' ' + std::to_string(width) + "\" " + type +
         " Format=\"HDF\">" + place + "</DataItem>";
}

/// Stress is a "Matrix" of six columns: XDMF's Tensor6 would have them in the order xx xy xz yy yz zz.
std::string attribute(const char* name, const char* kind, const char* centre, const std::string& data) {
  return std::string("    <Attribute Name=\"") + name + "\" AttributeType=\"" + kind + "\" Center=\"" + centre + "\">" +
         data + "</Attribute>\n";
}

/// A table of results.h5 with so many rows a frame.
struct FrameTable {
  const char* name;
  const char* dataset;
  hid_t type;
  hsize_t rows, width;
};

void add_view(hid_t group, const FrameTable& of, hsize_t frame, hsize_t frames) {
  const hsize_t whole[] = {frames * of.rows, of.width}, part[] = {of.rows, of.width}, start[] = {frame * of.rows, 0};
  const std::string what = std::string("cannot describe ") + of.name;
  const hdf5::Handle source(hdf5::check(H5Screate_simple(2, whole, nullptr), what));
  hdf5::check(H5Sselect_hyperslab(source, H5S_SELECT_SET, start, nullptr, part, nullptr), what);
  const hdf5::Handle space(hdf5::check(H5Screate_simple(2, part, nullptr), what));
  const hdf5::Handle layout(hdf5::check(H5Pcreate(H5P_DATASET_CREATE), what));
  hdf5::check(H5Pset_virtual(layout, space, "results.h5", of.dataset, source), what);
  const hdf5::Handle view(
      hdf5::check(H5Dcreate2(group, of.name, of.type, space, H5P_DEFAULT, layout, H5P_DEFAULT), what));
}

/// Virtual datasets (HDF5 1.10), some hundred bytes each, that read their numbers from results.h5: /0/points,
/// /0/displacement, /0/velocity, /0/stress, /1/… Some frames at a time: the library keeps 70 kB of each in memory as
/// long as the file is open.
void write_views(const std::filesystem::path& file, hsize_t frames, hsize_t nodes, hsize_t tetrahedra) {
  const FrameTable tables[] = {
      {"points", "/VTKHDF/Points", H5T_NATIVE_DOUBLE, nodes, 3},
      {"displacement", "/VTKHDF/PointData/displacement", H5T_NATIVE_DOUBLE, nodes, 3},
      {"velocity", "/VTKHDF/PointData/velocity", H5T_NATIVE_DOUBLE, nodes, 3},
      {"stress", "/VTKHDF/CellData/stress", H5T_NATIVE_FLOAT, tetrahedra, 6},
  };
  const hdf5::Handle access(hdf5::check(H5Pcreate(H5P_FILE_ACCESS), "cannot describe a file"));
  hdf5::check(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_LATEST), "cannot describe a file");
  constexpr hsize_t at_a_time = 25;
  hsize_t frame = 0;
  do {
    const hdf5::Handle views(hdf5::check(frame == 0 ? H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)
                                                    : H5Fopen(file.c_str(), H5F_ACC_RDWR, access),
                                         "cannot be written"));
    const hsize_t end = std::min(frames, frame + at_a_time);
    for (; frame < end; ++frame) {
      const hdf5::Handle group = hdf5::create_group(views, "/" + std::to_string(frame));
      for (const FrameTable& table : tables) add_view(group, table, frame, frames);
    }
    hdf5::check(H5Fflush(views, H5F_SCOPE_GLOBAL), "cannot be written");
  } while (frame < frames);
}

}  // namespace

XdmfIndex::XdmfIndex(std::filesystem::path file, const std::string& name, std::uint64_t nodes, std::uint64_t tetrahedra)
    : path_(std::move(file)),
      name_(name),
      descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)),
      nodes_(nodes),
      tetrahedra_(tetrahedra) {
  insert(beginning());
}

XdmfIndex::~XdmfIndex() { ::close(descriptor_); }

void XdmfIndex::add_frame(double time) {
  times_.push_back(time);
  insert(grid(times_.size() - 1, Frames::rows_of_tables));
}

void XdmfIndex::finish() {
  write_whole_frames();
  replace_file(path_, [&](std::ostream& text) {
    text << beginning();
    for (std::size_t frame = 0; frame < times_.size(); ++frame) text << grid(frame, Frames::whole);
    text << closing_tags;
  });
}

void XdmfIndex::write_whole_frames() const {
  const std::filesystem::path file = path_.parent_path() / "frames.h5", fresh = file.string() + ".new";
  try {
    const std::lock_guard lock(hdf5::library_mutex());
    write_views(fresh, times_.size(), nodes_, tetrahedra_);
  } catch (const hdf5::Error& error) {
    throw WriteError(fresh, error.what());
  }
  rename_file(fresh, file);
}

std::string XdmfIndex::beginning() const {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"2.0\">\n <Domain>\n  <Grid Name=\"" +
         xml_text(name_) + "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
}

std::string XdmfIndex::grid(std::size_t frame, Frames as) const {
  const bool whole = as == Frames::whole;
  const auto table = [&](const char* view, std::uint64_t rows, std::uint64_t width, const char* type,
                         const char* dataset) {
    return whole ? whole_table(rows, width, type, "frames.h5:/" + std::to_string(frame) + "/" + view)
                 : rows_of_frame(frame, rows, width, type, dataset);
  };
  const std::string corners = whole ? whole_table(tetrahedra_, 4, integer64, "results.h5:/VTKHDF/Connectivity")
                                    : wrapped_column(4 * tetrahedra_, integer64, "/VTKHDF/Connectivity");
  return "   <Grid Name=\"frame " + std::to_string(frame) + "\" GridType=\"Uniform\">\n    <Time Value=\"" +
         number_text(times_[frame]) + "\"/>\n    <Topology TopologyType=\"Tetrahedron\" NumberOfElements=\"" +
         std::to_string(tetrahedra_) + "\">" + corners + "</Topology>\n    <Geometry GeometryType=\"XYZ\">" +
         table("points", nodes_, 3, float64, "/VTKHDF/Points") + "</Geometry>\n" +
         attribute("displacement", "Vector", "Node",
                   table("displacement", nodes_, 3, float64, "/VTKHDF/PointData/displacement")) +
         attribute("velocity", "Vector", "Node", table("velocity", nodes_, 3, float64, "/VTKHDF/PointData/velocity")) +
         attribute("stress", "Matrix", "Cell", table("stress", tetrahedra_, 6, float32, "/VTKHDF/CellData/stress")) +
         attribute("block", "Scalar", "Cell", column(tetrahedra_, integer32, "/VTKHDF/CellData/block")) +
         attribute("material", "Scalar", "Cell", column(tetrahedra_, integer32, "/VTKHDF/CellData/material")) +
         "   </Grid>\n";
}

/// Puts the text before the closing tags, in one write that stays on one page.
void XdmfIndex::insert(const std::string& text) {
  const std::uint64_t end = closing_tags_at_ + text.size() + closing_tags.size() + instruction_begin.size();
  if (closing_tags_at_ > 0 && end / page > closing_tags_at_ / page) move_closing_tags_to_next_page();
  write(closing_tags_at_, text + closing_tags);
  closing_tags_at_ += text.size();
}

/// Each write stays on one page and leaves the file well-formed:
///   tags spaces |                     spaces may follow the document
///   tags spaces | <?moved ?>          so may an instruction
///   tags <?moving | <?moved ?>        … which may begin before the page
///   tags <?moving | tags <?moved ?>   … and hold anything
///        spaces   | tags <?moved ?>
void XdmfIndex::move_closing_tags_to_next_page() {
  const std::uint64_t boundary = (closing_tags_at_ / page + 1) * page;
  const std::uint64_t behind = closing_tags_at_ + closing_tags.size();
  write(behind, std::string(boundary - behind, ' '));
  write(boundary, instruction);
  write(behind, instruction_begin);
  write(boundary, closing_tags + instruction);
  write(closing_tags_at_, std::string(boundary - closing_tags_at_, ' '));
  closing_tags_at_ = boundary;
}

void XdmfIndex::write(std::uint64_t at, const std::string& text) {
  if (::pwrite(descriptor_, text.data(), text.size(), static_cast<off_t>(at)) != static_cast<ssize_t>(text.size()))
    throw WriteError(path_);
}

}  // namespace talus
