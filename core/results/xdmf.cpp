#include "results/xdmf.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <stdexcept>

#include "model/number_text.hpp"
#include "results/xml_text.hpp"

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

/// Stress is a "Matrix" of six columns: XDMF's Tensor6 would have them in the order xx xy xz yy yz zz.
std::string attribute(const char* name, const char* kind, const char* centre, const std::string& data) {
  return std::string("    <Attribute Name=\"") + name + "\" AttributeType=\"" + kind + "\" Center=\"" + centre + "\">" +
         data + "</Attribute>\n";
}

}  // namespace

XdmfIndex::XdmfIndex(std::filesystem::path file, const std::string& name, std::uint64_t nodes, std::uint64_t tetrahedra)
    : path_(std::move(file)),
      descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)),
      nodes_(nodes),
      tetrahedra_(tetrahedra) {
  insert("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"2.0\">\n <Domain>\n  <Grid Name=\"" +
         xml_text(name) + "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n");
}

XdmfIndex::~XdmfIndex() { ::close(descriptor_); }

void XdmfIndex::add_frame(double time) {
  insert(grid(time));
  ++frames_;
}

std::string XdmfIndex::grid(double time) const {
  const auto of_nodes = [&](const char* dataset) { return rows_of_frame(frames_, nodes_, 3, float64, dataset); };
  return "   <Grid Name=\"frame " + std::to_string(frames_) + "\" GridType=\"Uniform\">\n    <Time Value=\"" +
         number_text(time) + "\"/>\n    <Topology TopologyType=\"Tetrahedron\" NumberOfElements=\"" +
         std::to_string(tetrahedra_) + "\">" + wrapped_column(4 * tetrahedra_, integer64, "/VTKHDF/Connectivity") +
         "</Topology>\n    <Geometry GeometryType=\"XYZ\">" + of_nodes("/VTKHDF/Points") + "</Geometry>\n" +
         attribute("displacement", "Vector", "Node", of_nodes("/VTKHDF/PointData/displacement")) +
         attribute("velocity", "Vector", "Node", of_nodes("/VTKHDF/PointData/velocity")) +
         attribute("stress", "Matrix", "Cell",
                   rows_of_frame(frames_, tetrahedra_, 6, float32, "/VTKHDF/CellData/stress")) +
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
    throw std::runtime_error(path_.string() + ": cannot be written; is the disk full?");
}

}  // namespace talus
