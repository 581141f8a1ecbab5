#include "csv.hpp"

#include <fstream>

#include "base/error.hpp"
#include "results/text_table.hpp"

namespace talus::cli {

namespace {

/// A table of rows that begin with words (of blocks, joints) and go on with numbers.
class CsvFile {
 public:
  CsvFile(const std::filesystem::path& stem, const char* what, const char* header)
      : path_(stem.string() + "-" + what + ".csv"), stream_(path_) {
    stream_ << header << '\n';
  }

  void add(const std::vector<std::string>& words, const std::vector<double>& numbers) {
    for (const std::string& word : words) stream_ << csv_field(word) << ',';
    stream_ << csv_line(numbers) << '\n';
  }

  void finish() {
    if (!stream_.flush())
      throw InputError(path_.string(), "cannot be written",
                       "choose a folder that can be written to, on a disk with room");
  }

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
};

void append(std::vector<double>& row, const auto& vector) { row.insert(row.end(), vector.begin(), vector.end()); }

void write_nodes(const BlockSystem& system, const Frame& frame, const std::filesystem::path& stem) {
  CsvFile file(stem, "nodes", "block,node,x [m],y [m],z [m],ux [m],uy [m],uz [m],vx [m/s],vy [m/s],vz [m/s]");
  std::size_t node = 0;
  for (const Block& block : system.blocks)
    for (const Vec3& start : block.mesh.nodes) {
      std::vector<double> row{static_cast<double>(node)};
      append(row, Vec3(start + frame.displacement[node]));
      append(row, frame.displacement[node]);
      append(row, frame.velocity[node]);
      file.add({block.name}, row);
      ++node;
    }
  file.finish();
}

void write_tetrahedra(const BlockSystem& system, const Frame& frame, const std::filesystem::path& stem) {
  CsvFile file(stem, "tetrahedra",
               "block,tetrahedron,node,node,node,node,xx [Pa],yy [Pa],zz [Pa],xy [Pa],yz [Pa],zx [Pa]");
  std::size_t tetrahedron = 0, first_node = 0;
  for (const Block& block : system.blocks) {
    for (const auto& nodes : block.mesh.tetrahedra) {
      std::vector<double> row{static_cast<double>(tetrahedron)};
      for (const int node : nodes) row.push_back(static_cast<double>(first_node) + node);
      append(row, frame.stress[tetrahedron]);
      file.add({block.name}, row);
      ++tetrahedron;
    }
    first_node += block.mesh.nodes.size();
  }
  file.finish();
}

const char* word(ContactState state) {
  switch (state) {
    case ContactState::open:
      return "open";
    case ContactState::stick:
      return "stick";
    case ContactState::slip:
      break;
  }
  return "slip";
}

void write_contacts(const BlockSystem& system, const Frame& frame, const std::filesystem::path& stem) {
  CsvFile file(stem, "contacts",
               "first block,second block,joint,state,x [m],y [m],z [m],nx,ny,nz,normal force [N],"
               "shear force x [N],shear force y [N],shear force z [N],area [m²]");
  const auto block = [&](int index) { return system.blocks[static_cast<std::size_t>(index)].name; };
  for (const ContactSample& contact : frame.contacts) {
    std::vector<double> row;
    append(row, contact.position);
    append(row, contact.normal);
    row.push_back(contact.normal_force);
    append(row, contact.shear_force);
    row.push_back(contact.area);
    const std::string joint = contact.joint < 0 ? "" : system.joint_names[static_cast<std::size_t>(contact.joint)];
    file.add({block(contact.blocks[0]), block(contact.blocks[1]), joint, word(contact.state)}, row);
  }
  file.finish();
}

}  // namespace

void write_csv(const BlockSystem& system, const Frame& frame, const std::filesystem::path& stem) {
  write_nodes(system, frame, stem);
  write_tetrahedra(system, frame, stem);
  write_contacts(system, frame, stem);
}

}  // namespace talus::cli
