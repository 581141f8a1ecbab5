#include <bit>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "base/base64.hpp"
#include "export/export.hpp"
#include "export/export_folder.hpp"
#include "mesh/block.hpp"
#include "model/number_text.hpp"
#include "results/field.hpp"
#include "results/vtk_cells.hpp"

namespace talus {

namespace {

/// The arrays of a file: their declarations, and their bytes, each behind its length, for the end of the file: in
/// base64, for with raw bytes the file is no XML.
class AppendedData {
 public:
  /// Declares an array of rows × `components` numbers and keeps its bytes. `attributes`: more of its XML attributes.
  template <class Number>
  std::string add(const std::string& name, const char* type, int components, const std::vector<Number>& numbers,
                  const std::string& attributes = "") {
    const std::string declaration = "<DataArray type=\"" + std::string(type) + "\" Name=\"" + name +
                                    "\" NumberOfComponents=\"" + std::to_string(components) + "\" " + attributes +
                                    "format=\"appended\" offset=\"" + std::to_string(text_.size()) + "\"/>\n";
    const std::uint64_t length = numbers.size() * sizeof(Number);
    std::string bytes(reinterpret_cast<const char*>(&length), sizeof length);
    bytes.append(reinterpret_cast<const char*>(numbers.data()), length);
    text_ += base64(bytes);
    return declaration;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

template <class Vector>
std::vector<double> flat(const std::vector<Vector>& vectors) {
  std::vector<double> numbers;
  for (const Vector& vector : vectors) numbers.insert(numbers.end(), vector.begin(), vector.end());
  return numbers;
}

/// Nodes where they are in the frame.
std::vector<double> moved_nodes(const BlockSystem& system, const Frame& frame) {
  std::vector<Vec3> nodes;
  for (const Block& block : system.blocks) nodes.insert(nodes.end(), block.mesh.nodes.begin(), block.mesh.nodes.end());
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] += frame.displacement[i];
  return flat(nodes);
}

struct Cells {
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<std::int32_t> block, material;
};

Cells cells_of(const BlockSystem& system) {
  Cells cells;
  std::int64_t first_node = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    for (const auto& tetrahedron : block.mesh.tetrahedra) {
      for (const int node : tetrahedron) cells.connectivity.push_back(first_node + node);
      cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
      cells.block.push_back(static_cast<std::int32_t>(b));
      cells.material.push_back(block.material);
    }
    first_node += static_cast<std::int64_t>(block.mesh.nodes.size());
  }
  return cells;
}

/// Names for the six components, so that a viewer shows them instead of numbers.
std::string component_names() {
  std::string names;
  int i = 0;
  for (const char* name : {"xx", "yy", "zz", "xy", "yz", "zx"})
    names += "ComponentName" + std::to_string(i++) + "=\"" + name + "\" ";
  return names;
}

/// A VTK XML unstructured grid, readable from VTK 6 on.
void write_vtu(std::ostream& stream, const BlockSystem& system, const Frame& frame) {
  static_assert(std::endian::native == std::endian::little);
  const Cells cells = cells_of(system);
  AppendedData data;
  stream << "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
            "<UnstructuredGrid>\n<FieldData>\n"
         << data.add("TimeValue", "Float64", 1, std::vector{frame.time}, "NumberOfTuples=\"1\" ")
         << "</FieldData>\n<Piece NumberOfPoints=\"" << frame.displacement.size() << "\" NumberOfCells=\""
         << cells.block.size() << "\">\n<PointData>\n"
         << data.add("displacement", "Float64", 3, flat(frame.displacement))
         << data.add("velocity", "Float64", 3, flat(frame.velocity)) << "</PointData>\n<CellData>\n"
         << data.add("stress", "Float64", 6, flat(frame.stress), component_names())
         << data.add("von Mises stress", "Float64", 1, values(frame, field_named("stress.von_mises")))
         << data.add("block", "Int32", 1, cells.block) << data.add("material", "Int32", 1, cells.material)
         << "</CellData>\n<Points>\n"
         << data.add("points", "Float64", 3, moved_nodes(system, frame)) << "</Points>\n<Cells>\n"
         << data.add("connectivity", "Int64", 1, cells.connectivity) << data.add("offsets", "Int64", 1, cells.offsets)
         << data.add("types", "UInt8", 1, std::vector<std::uint8_t>(cells.block.size(), vtk_tetra))
         << "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"base64\">\n_" << data.text()
         << "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace

void export_vtu(const ResultReader& results, std::span<const int> frames, const std::filesystem::path& folder,
                Progress& progress) {
  prepare_export_folder(folder);
  std::string collection =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for_each_frame(results, frames, progress, [&](const Frame& frame) {
    const std::string name = numbered_name("frame", frame.index, ".vtu");
    write_export_file(folder / name, [&](std::ostream& stream) { write_vtu(stream, results.system(), frame); });
    collection +=
        "<DataSet timestep=\"" + number_text(frame.time) + "\" group=\"\" part=\"0\" file=\"" + name + "\"/>\n";
  });
  write_export_file(folder / "frames.pvd",
                    [&](std::ostream& stream) { stream << collection << "</Collection>\n</VTKFile>\n"; });
}

}  // namespace talus
