#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "results/folder.hpp"
#include "results/frame_tables.hpp"
#include "results/hdf5.hpp"
#include "results/readable_file.hpp"
#include "results/result_file.hpp"
#include "results/stored_rows.hpp"
#include "results/superblock.hpp"
#include "results/vtk_cells.hpp"

namespace talus {

using hdf5::check;
using hdf5::Handle;
using hdf5::Table;

namespace {

constexpr hsize_t number_chunk = 512;   // frames a piece of the small tables
constexpr hsize_t contact_chunk = 256;  // contacts a piece
constexpr hsize_t motion_chunk = 256;   // classes of motion a piece
constexpr hsize_t sleep_chunk = 4096;   // flags of sleep a piece
constexpr std::int8_t not_noted = -1;   // of a frame that does not tell who sleeps

std::vector<std::string> names_of(const auto& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(thing.name);
  return names;
}

/// Nodes, tetrahedra and surface triangles of all blocks one after another, numbered through.
struct FlatMesh {
  std::vector<double> nodes;
  std::vector<std::int64_t> tetrahedra;
  std::vector<std::int32_t> block, material;  // a tetrahedron
  std::vector<std::int64_t> triangles;
  std::vector<std::int32_t> triangle_joint;
};

FlatMesh flatten(const BlockSystem& system) {
  FlatMesh flat;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    const auto first = static_cast<std::int64_t>(flat.nodes.size() / 3);
    for (const Vec3& node : block.mesh.nodes) flat.nodes.insert(flat.nodes.end(), node.begin(), node.end());
    for (const auto& tetrahedron : block.mesh.tetrahedra)
      for (const int node : tetrahedron) flat.tetrahedra.push_back(first + node);
    for (const SurfaceTriangle& triangle : block.surface) {
      for (const int node : triangle.nodes) flat.triangles.push_back(first + node);
      flat.triangle_joint.push_back(triangle.joint);
    }
    flat.block.resize(flat.tetrahedra.size() / 4, static_cast<std::int32_t>(b));
    flat.material.resize(flat.tetrahedra.size() / 4, block.material);
  }
  return flat;
}

void write_blocks(hid_t talus, const BlockSystem& system) {
  const Handle group = hdf5::create_group(talus, "blocks");
  std::vector<std::int32_t> solid, material, nodes, tetrahedra, triangles, on_corners;
  std::vector<std::string> body, body_reason;
  std::vector<double> volume;
  for (const Block& block : system.blocks) {
    solid.push_back(block.solid);
    material.push_back(block.material);
    body.emplace_back(to_string(block.body));
    body_reason.push_back(block.body_reason);
    nodes.push_back(static_cast<std::int32_t>(block.mesh.nodes.size()));
    tetrahedra.push_back(static_cast<std::int32_t>(block.mesh.tetrahedra.size()));
    triangles.push_back(static_cast<std::int32_t>(block.surface.size()));
    volume.push_back(block.volume);
    on_corners.push_back(block.stands_on_corners ? 1 : 0);
  }
  hdf5::write_strings(group, "name", names_of(system.blocks));
  hdf5::write_fixed(group, "solid", solid);
  hdf5::write_fixed(group, "material", material);
  hdf5::write_strings(group, "body", body);
  hdf5::write_strings(group, "body_reason", body_reason);
  hdf5::write_fixed(group, "volume", volume);
  hdf5::write_fixed(group, "nodes", nodes);
  hdf5::write_fixed(group, "tetrahedra", tetrahedra);
  hdf5::write_fixed(group, "triangles", triangles);
  hdf5::write_fixed(group, "stands_on_corners", on_corners);
}

/// 1 for a monitor that records stress, else 0.
std::vector<std::int32_t> stress_flags(const std::vector<Monitor>& monitors) {
  std::vector<std::int32_t> flags;
  for (const Monitor& monitor : monitors) flags.push_back(monitor.stress ? 1 : 0);
  return flags;
}

/// Cohesion [Pa], friction angle [degrees] and tensile strength [Pa] of a material; no numbers where it has none.
std::vector<double> strength_rows(const Project& project) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> rows;
  for (const Material& material : project.materials) {
    const RockStrength strength = material.strength.value_or(RockStrength{none, none, none});
    rows.insert(rows.end(), {strength.cohesion, strength.friction_angle, strength.tensile_strength.value_or(none)});
  }
  return rows;
}

/// /Talus: names, blocks and the undeformed mesh; the contacts of the frames.
void create_talus(hid_t file, const Project& project, const BlockSystem& system, const FlatMesh& flat) {
  const Handle group = hdf5::create_group(file, "/Talus");
  hdf5::write_attribute(group, "format", std::vector<std::int64_t>{1});
  hdf5::write_attribute(group, "solids_volume", std::vector<double>{system.solids_volume});
  hdf5::write_strings(group, "project", {project.name});
  hdf5::write_strings(group, "joints", system.joint_names);
  hdf5::write_strings(group, "materials", names_of(project.materials));
  hdf5::write_fixed(group, "material_strengths", strength_rows(project), 3);
  hdf5::write_strings(group, "stages", names_of(project.stages));
  hdf5::write_strings(group, "monitors", names_of(project.monitors));
  hdf5::write_fixed(group, "monitor_stress", stress_flags(project.monitors));
  write_blocks(group, system);
  hdf5::write_fixed(group, "nodes", flat.nodes, 3);
  hdf5::write_fixed(group, "triangles", flat.triangles, 3);
  hdf5::write_fixed(group, "triangle_joint", flat.triangle_joint);
  Table::create(group, "frame_index", H5T_NATIVE_INT32, 0, number_chunk);
  Table::create(group, "frame_stage", H5T_NATIVE_INT32, 0, number_chunk);
  Table::create(group, "contact_end", H5T_NATIVE_INT64, 0, number_chunk);
  Table::create(group, "contacts", stored_contact_type(), 0, contact_chunk);
  Table::create(group, "motion_end", H5T_NATIVE_INT64, 0, number_chunk);
  Table::create(group, "motions", stored_motion_type(), 0, motion_chunk);
  Table::create(group, "asleep", H5T_NATIVE_INT8, 0, sleep_chunk);
}

/// The tables of /VTKHDF/Steps that say where a frame's rows begin, and how many rows it adds to what they point at.
struct OffsetTable {
  const char* name;
  enum { nothing, nodes, tetrahedra } moves_by;
};
constexpr OffsetTable offset_tables[] = {{"PartOffsets", OffsetTable::nothing},
                                         {"PointOffsets", OffsetTable::nodes},
                                         {"CellOffsets", OffsetTable::nothing},
                                         {"ConnectivityIdOffsets", OffsetTable::nothing},
                                         {"PointDataOffsets/displacement", OffsetTable::nodes},
                                         {"PointDataOffsets/velocity", OffsetTable::nodes},
                                         {"CellDataOffsets/stress", OffsetTable::tetrahedra},
                                         {"CellDataOffsets/block", OffsetTable::nothing},
                                         {"CellDataOffsets/material", OffsetTable::nothing}};

/// /VTKHDF/Steps: every frame reads the one part's cells anew and its own rows of points and data.
void create_steps(hid_t vtkhdf) {
  const Handle steps = hdf5::create_group(vtkhdf, "Steps");
  hdf5::write_attribute(steps, "NSteps", std::vector<std::int64_t>{0});
  hdf5::create_group(steps, "PointDataOffsets");
  hdf5::create_group(steps, "CellDataOffsets");
  Table::create(steps, "Values", H5T_NATIVE_DOUBLE, 0, number_chunk);
  Table::create(steps, "NumberOfParts", H5T_NATIVE_INT64, 0, number_chunk);
  for (const OffsetTable& table : offset_tables) Table::create(steps, table.name, H5T_NATIVE_INT64, 0, number_chunk);
}

void create_vtkhdf(hid_t file, const FlatMesh& flat) {
  const std::size_t node_count = flat.nodes.size() / 3, tetrahedron_count = flat.tetrahedra.size() / 4;
  const Handle group = hdf5::create_group(file, "/VTKHDF");
  hdf5::write_attribute(group, "Version", std::vector<std::int64_t>{2, 0});
  hdf5::write_attribute(group, "Type", "UnstructuredGrid");
  const auto count = [&](const char* name, std::size_t number) {
    hdf5::write_fixed(group, name, std::vector<std::int64_t>{static_cast<std::int64_t>(number)});
  };
  count("NumberOfPoints", node_count);
  count("NumberOfCells", tetrahedron_count);
  count("NumberOfConnectivityIds", flat.tetrahedra.size());

  std::vector<std::int64_t> offsets(tetrahedron_count + 1);
  for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = static_cast<std::int64_t>(4 * i);
  hdf5::write_fixed(group, "Connectivity", flat.tetrahedra);
  hdf5::write_fixed(group, "Offsets", offsets);
  hdf5::write_fixed(group, "Types", std::vector<std::uint8_t>(tetrahedron_count, vtk_tetra));
  Table::create(group, "Points", H5T_NATIVE_DOUBLE, 3, node_count);

  const Handle point_data = hdf5::create_group(group, "PointData");
  Table::create(point_data, "displacement", H5T_NATIVE_DOUBLE, 3, node_count);
  Table::create(point_data, "velocity", H5T_NATIVE_DOUBLE, 3, node_count);
  const Handle cell_data = hdf5::create_group(group, "CellData");
  hdf5::write_fixed(cell_data, "block", flat.block);
  hdf5::write_fixed(cell_data, "material", flat.material);
  Table::create(cell_data, "stress", H5T_NATIVE_FLOAT, 6, tetrahedron_count);
  create_steps(group);
}

/// Rows of which a frame has as many as it likes, and where they end.
template <class Row, class Thing>
void append_list(const std::vector<Thing>& things, Table& table, Table& ends, std::int64_t& end) {
  std::vector<Row> rows;
  for (const Thing& thing : things) rows.push_back(stored(thing));
  table.append(rows.data(), rows.size());
  end += static_cast<std::int64_t>(rows.size());
  ends.append(&end, 1);
}

/// Rows are written once and in order, so pieces that are written need not be kept. Left to itself HDF5 keeps 521 of
/// each table, or 1 MB.
void keep_few_pieces(hid_t access) {
  constexpr std::size_t slots = 7, bytes = 16384;
  constexpr double written_ones_go_first = 1;
  check(H5Pset_cache(access, 0, slots, bytes, written_ones_go_first), "cannot be made");
}

/// Of the newest format, which single-writer–multiple-readers mode asks for, and readable by others meanwhile.
Handle newest_format() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // reasons go into exceptions, not onto the terminal
  Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "cannot be made"));
  check(H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST), "cannot be made");
  keep_few_pieces(access);
  hdf5::write_readably(access);
  return access;
}

/// Who writes reads pieces of a file again and again that are damaged, as if somebody wrote them at that moment, with
/// pauses that double from 1 ns on: HDF5's own hundred times would never be over.
Handle reopen_file(const std::filesystem::path& path) {
  constexpr unsigned attempts = 20;
  const Handle access = newest_format();
  check(H5Pset_metadata_read_attempts(access, attempts), "cannot be told how often to read");
  return Handle(check(H5Fopen(path.c_str(), H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE, access), "cannot be opened"));
}

Handle create_file(const std::filesystem::path& path) {
  const Handle access = newest_format();
  // A kill may tear a write between two pages of the system's file cache; with pages of that size in the file, no
  // small piece of HDF5's own data lies across two.
  const Handle creation(check(H5Pcreate(H5P_FILE_CREATE), "cannot be made"));
  check(H5Pset_file_space_strategy(creation, H5F_FSPACE_STRATEGY_PAGE, false, 1), "cannot be made");
  check(H5Pset_file_space_page_size(creation, 4096), "cannot be made");
  return Handle(check(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access), "cannot be made"));
}

/// results.vtkhdf beside results.h5: nothing but a link to its /VTKHDF. ParaView goes by the ending.
void link_as_vtkhdf(const std::filesystem::path& results) {
  const std::filesystem::path link = std::filesystem::path(results).replace_extension(".vtkhdf");
  const std::filesystem::path fresh = link.string() + ".new";
  {
    const Handle file(check(H5Fcreate(fresh.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), "cannot be made"));
    check(H5Lcreate_external(results.filename().c_str(), "/VTKHDF", file, "/VTKHDF", H5P_DEFAULT, H5P_DEFAULT),
          "cannot be linked");
  }
  rename_file(fresh, link);
}

}  // namespace

struct ResultFileWriter::State : FrameTables {
  std::filesystem::path path;
  std::vector<double> nodes;
  hsize_t node_count = 0, tetrahedron_count = 0, block_count = 0;
  std::int64_t frames = 0, contact_end = 0, motion_end = 0;
  std::int64_t announced = 0;  // frames; those that are written again among them
  Handle file, steps, step_count;
  Table points, parts, times;
  std::vector<Table> offsets;

  template <class Open>
  void begin(const std::filesystem::path& results, const BlockSystem& system, int frame_count, const Open& open);
  void open_growing();
  void go_back_to(std::int64_t frame_count);
  void look_at_last(hsize_t rows) const;
  void append(const Frame& frame);
  void announce(double time);
  void flush();
};

void ResultFileWriter::State::open_growing() {
  points = Table(file, "/VTKHDF/Points", H5T_NATIVE_DOUBLE, 3);
  open_in(file);
  parts = Table(file, "/VTKHDF/Steps/NumberOfParts", H5T_NATIVE_INT64);
  times = Table(file, "/VTKHDF/Steps/Values", H5T_NATIVE_DOUBLE);
  for (const OffsetTable& table : offset_tables)
    offsets.emplace_back(file, std::string("/VTKHDF/Steps/") + table.name, H5T_NATIVE_INT64);
  steps = Handle(check(H5Gopen2(file, "/VTKHDF/Steps", H5P_DEFAULT), "cannot open Steps"));
  step_count = Handle(check(H5Aopen(steps, "NSteps", H5P_DEFAULT), "cannot open NSteps"));
}

/// Of the same frames again the same is written: who reads them meanwhile sees no other, and they stay announced.
void ResultFileWriter::State::go_back_to(std::int64_t frame_count) {
  frames = frame_count;
  announced = hdf5::read_number_attribute<std::int64_t>(steps, "NSteps");
  const auto rows = static_cast<hsize_t>(frames);
  for (Table* table : {&parts, &times, &index, &stage, &contact_ends, &motion_ends}) table->go_back_to(rows);
  for (Table& table : offsets) table.go_back_to(rows);
  if (frames > 0) {
    contact_ends.read(&contact_end, rows - 1, 1);
    motion_ends.read(&motion_end, rows - 1, 1);
  }
  contacts.go_back_to(static_cast<hsize_t>(contact_end));
  motions.go_back_to(static_cast<hsize_t>(motion_end));
  for (Table* table : {&points, &displacement, &velocity}) table->go_back_to(rows * node_count);
  look_at_last(rows);
  stress.go_back_to(rows * tetrahedron_count);
  asleep.go_back_to(rows * block_count);
}

/// Of the tables that only other programs read: one that is damaged is found before something is written.
void ResultFileWriter::State::look_at_last(hsize_t rows) const {
  if (rows == 0) return;
  std::int64_t number = 0;
  parts.read(&number, rows - 1, 1);
  for (const Table& table : offsets) table.read(&number, rows - 1, 1);
  std::vector<double> last(3 * node_count);
  points.read(last.data(), (rows - 1) * node_count, node_count);
}

void ResultFileWriter::State::append(const Frame& frame) {
  std::vector<double> moved(nodes);
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += frame.displacement[i / 3][static_cast<int>(i % 3)];
  points.append(moved.data(), node_count);
  displacement.append(frame.displacement.data(), node_count);
  velocity.append(frame.velocity.data(), node_count);
  stress.append(frame.stress.data(), tetrahedron_count);

  append_list<StoredContact>(frame.contacts, contacts, contact_ends, contact_end);
  append_list<StoredMotion>(frame.motions, motions, motion_ends, motion_end);
  std::vector<std::int8_t> sleepers(frame.asleep.begin(), frame.asleep.end());
  sleepers.resize(block_count, not_noted);
  asleep.append(sleepers.data(), block_count);
  index.append(&frame.index, 1);
  stage.append(&frame.stage, 1);

  const std::int64_t one_part = 1;
  parts.append(&one_part, 1);
  const std::int64_t moves[] = {0, static_cast<std::int64_t>(node_count), static_cast<std::int64_t>(tetrahedron_count)};
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const std::int64_t offset = frames * moves[offset_tables[i].moves_by];
    offsets[i].append(&offset, 1);
  }
}

/// Makes the frame known once everything of it has left this process: readers count the rows of Values, or, as VTKHDF
/// has it, ask for NSteps.
void ResultFileWriter::State::announce(double time) {
  flush();
  times.append(&time, 1);
  flush();
  announced = std::max(announced, ++frames);
  check(H5Awrite(step_count, H5T_NATIVE_INT64, &announced), "cannot write NSteps");
  flush();
}

void ResultFileWriter::State::flush() { check(H5Fflush(file, H5F_SCOPE_LOCAL), "cannot be written"); }

/// `open` gives the file, in the mode of a single writer, for the blocks' flat mesh.
template <class Open>
void ResultFileWriter::State::begin(const std::filesystem::path& results, const BlockSystem& system, int frame_count,
                                    const Open& open) {
  const std::lock_guard lock(hdf5::library_mutex());
  try {
    FlatMesh flat = flatten(system);
    path = results;
    block_count = system.blocks.size();
    node_count = flat.nodes.size() / 3;
    tetrahedron_count = flat.tetrahedra.size() / 4;
    file = open(flat);
    open_growing();
    go_back_to(frame_count);
    nodes = std::move(flat.nodes);
  } catch (const hdf5::Error& error) {
    throw std::runtime_error(results.string() + ": " + error.what());
  }
}

ResultFileWriter::ResultFileWriter(const std::filesystem::path& file, const Project& project, const BlockSystem& system)
    : state_(std::make_unique<State>()) {
  state_->begin(file, system, 0, [&](const FlatMesh& flat) {
    const std::filesystem::path fresh = file.string() + ".new";  // until all is in it that readers ask for
    Handle created = create_file(fresh);
    create_talus(created, project, system, flat);
    create_vtkhdf(created, flat);
    check(H5Fstart_swmr_write(created), "cannot be written");
    check(H5Fflush(created, H5F_SCOPE_LOCAL), "cannot be written");
    rename_file(fresh, file);
    link_as_vtkhdf(file);
    return created;
  });
}

ResultFileWriter::ResultFileWriter(const std::filesystem::path& file, const BlockSystem& system, int frames)
    : state_(std::make_unique<State>()) {
  state_->begin(file, system, frames, [&](const FlatMesh&) {
    mark_closed(file);
    return reopen_file(file);
  });
}

ResultFileWriter::~ResultFileWriter() {
  const std::lock_guard lock(hdf5::library_mutex());
  state_.reset();
}

std::vector<double> ResultFileWriter::frame_times() const {
  const std::lock_guard lock(hdf5::library_mutex());
  std::vector<double> times(static_cast<std::size_t>(state_->frames));
  state_->times.read(times.data(), 0, times.size());
  return times;
}

void ResultFileWriter::add_frame(const Frame& frame) {
  if (frame.displacement.size() != state_->node_count || frame.velocity.size() != state_->node_count ||
      frame.stress.size() != state_->tetrahedron_count)
    throw std::invalid_argument("a frame has not as many nodes and tetrahedra as the blocks");
  const std::lock_guard lock(hdf5::library_mutex());
  try {
    state_->append(frame);
    state_->announce(frame.time);
  } catch (const hdf5::Error& error) {
    throw WriteError(state_->path, error.what());
  }
}

}  // namespace talus
