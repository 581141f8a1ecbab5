#include "results/vtu.hpp"

#include <charconv>
#include <fstream>
#include <stdexcept>

#include "results/field.hpp"
#include "results/xml_text.hpp"

namespace talus {

namespace {

constexpr int vtk_tetra = 10;  // VTK's number for a linear tetrahedron

class XmlFile {
 public:
  explicit XmlFile(const std::filesystem::path& file) : path_(file), stream_(file) {
    stream_ << "<?xml version=\"1.0\"?>\n";
  }

  void text(const std::string& text) { stream_ << text; }

  /// A DataArray of `components` columns; `fill(put)` puts its numbers.
  template <typename Fill>
  void array(const std::string& type, const std::string& name, int components, Fill fill) {
    stream_ << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
            << "\" format=\"ascii\">\n";
    fill([this](auto number) {
      char digits[32];
      const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
      stream_.write(digits, end - digits).put('\n');
    });
    stream_ << "</DataArray>\n";
  }

  template <typename Row>
  void rows(const std::string& name, const std::vector<Row>& rows) {
    array("Float64", name, static_cast<int>(Row::SizeAtCompileTime), [&](auto put) {
      for (const Row& row : rows)
        for (const double number : row) put(number);
    });
  }

  void finish() {
    if (!stream_.flush()) throw std::runtime_error("cannot write " + path_.string());
  }

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
};

std::vector<Vec3> positions(const BlockSystem& system, const Frame& frame) {
  std::vector<Vec3> positions;
  positions.reserve(frame.displacement.size());
  for (const Block& block : system.blocks)
    for (const Vec3& start : block.mesh.nodes) positions.push_back(start + frame.displacement[positions.size()]);
  return positions;
}

/// Calls `visit(block, first node, tetrahedron)` for every tetrahedron.
template <typename Visit>
void for_each_tetrahedron(const BlockSystem& system, Visit visit) {
  int first = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    for (const auto& tetrahedron : system.blocks[b].mesh.tetrahedra) visit(static_cast<int>(b), first, tetrahedron);
    first += static_cast<int>(system.blocks[b].mesh.nodes.size());
  }
}

void write_cells(XmlFile& file, const BlockSystem& system) {
  file.text("<Cells>\n");
  file.array("Int32", "connectivity", 1, [&](auto put) {
    for_each_tetrahedron(system, [&](int, int first, const auto& tetrahedron) {
      for (const int node : tetrahedron) put(first + node);
    });
  });
  file.array("Int32", "offsets", 1, [&](auto put) {
    int end = 0;
    for_each_tetrahedron(system, [&](int, int, const auto&) { put(end += 4); });
  });
  file.array("Int32", "types", 1,
             [&](auto put) { for_each_tetrahedron(system, [&](int, int, const auto&) { put(vtk_tetra); }); });
  file.text("</Cells>\n");
}

}  // namespace

void write_vtu(const BlockSystem& system, const Frame& frame, const std::filesystem::path& file) {
  XmlFile xml(file);
  xml.text("<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
           std::to_string(frame.displacement.size()) + "\" NumberOfCells=\"" + std::to_string(frame.stress.size()) +
           "\">\n<Points>\n");
  xml.rows("points", positions(system, frame));
  xml.text("</Points>\n");
  write_cells(xml, system);
  xml.text("<PointData>\n");
  xml.rows("displacement", frame.displacement);
  xml.rows("velocity", frame.velocity);
  xml.text("</PointData>\n<CellData>\n");
  xml.rows("stress", frame.stress);
  xml.array("Float64", "von Mises stress", 1, [&](auto put) {
    for (const Voigt& stress : frame.stress) put(von_mises(stress));
  });
  xml.array("Int32", "block", 1,
            [&](auto put) { for_each_tetrahedron(system, [&](int block, int, const auto&) { put(block); }); });
  xml.text("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  xml.finish();
}

void write_pvd(const std::vector<std::pair<double, std::string>>& frames, const std::filesystem::path& file) {
  XmlFile xml(file);
  xml.text("<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n");
  for (const auto& [time, name] : frames) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, time).ptr;
    xml.text("<DataSet timestep=\"" + std::string(digits, end) + "\" file=\"" + xml_text(name) + "\"/>\n");
  }
  xml.text("</Collection>\n</VTKFile>\n");
  xml.finish();
}

}  // namespace talus
