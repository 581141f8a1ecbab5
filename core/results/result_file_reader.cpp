#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <thread>

#include "base/error.hpp"
#include "results/folder.hpp"
#include "results/frame_tables.hpp"
#include "results/hdf5.hpp"
#include "results/result_file.hpp"
#include "results/stored_rows.hpp"

namespace talus {

using hdf5::check;
using hdf5::Handle;
using hdf5::Table;

namespace {

/// Opening looks at the file's end and then at its superblock; a writer in another process may come between, which
/// looks like a truncated file. It is gone at the next attempt. Where nobody writes the file is damaged.
constexpr int attempts = 20;
constexpr std::chrono::milliseconds between_attempts{2};

/// Of a piece that its checksum shows to be half written. The library doubles its pause from 1 ns on: these are over
/// after a second, and its own hundred would never be where a writer was killed. Where nobody writes the piece is
/// damaged, and a millisecond is enough.
constexpr unsigned piece_attempts = 30, piece_attempts_in_closed_file = 20;

Handle open_file(const std::filesystem::path& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // reasons go into exceptions, not onto the terminal
  const Handle access(H5Pcreate(H5P_FILE_ACCESS));
  const bool grows = is_written_to(path.parent_path());
  check(H5Pset_metadata_read_attempts(access, grows ? piece_attempts : piece_attempts_in_closed_file),
        "cannot be told how often to read");
  for (int attempt = 1; grows && attempt < attempts; ++attempt) {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access);
    if (file >= 0) return Handle(file);
    std::this_thread::sleep_for(between_attempts);
  }
  return Handle(check(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access), "cannot be opened"));
}

BodyKind body_kind(const std::string& word) {
  for (const BodyKind kind : {BodyKind::fixed, BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra})
    if (to_string(kind) == word) return kind;
  throw std::runtime_error("no kind of body is called " + word);
}

/// A disk may lose bits, and HDF5 keeps checksums of its own pages alone: whatever counts or points at something is
/// looked at before it is followed.
void need(bool whole, const char* what) {
  if (!whole) throw hdf5::Error(what);
}

bool is_index(std::int64_t number, std::size_t count) {
  return number >= 0 && static_cast<std::uint64_t>(number) < count;
}

bool is_index_or_none(std::int64_t number, std::size_t count) { return number == -1 || is_index(number, count); }

/// Adds up counts of a block each; there are so many things of `size` numbers.
void need_sum(const std::vector<std::int32_t>& counts, std::size_t numbers, std::size_t size, const char* what) {
  std::uint64_t sum = 0;
  for (const std::int32_t count : counts) {
    need(count >= 0, what);
    sum += static_cast<std::uint64_t>(count);
  }
  need(sum * size == numbers, what);
}

template <std::size_t count>
std::array<int, count> local_nodes(const std::int64_t* global, std::int64_t first, std::size_t node_count) {
  std::array<int, count> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    need(global[i] >= first && is_index(global[i] - first, node_count), "a node of the mesh is not there");
    nodes[i] = static_cast<int>(global[i] - first);
  }
  return nodes;
}

/// Results of earlier versions lack some datasets.
bool holds(hid_t parent, const char* path) { return H5Lexists(parent, path, H5P_DEFAULT) > 0; }

/// As Project::materials, where the file tells them.
std::vector<std::optional<RockStrength>> read_strengths(hid_t talus) {
  std::vector<std::optional<RockStrength>> strengths;
  if (!holds(talus, "material_strengths")) return strengths;
  const auto rows = hdf5::read_all<double>(talus, "material_strengths");
  for (std::size_t i = 0; i + 2 < rows.size(); i += 3) {
    auto& strength = strengths.emplace_back();
    if (std::isnan(rows[i])) continue;
    strength = RockStrength{.cohesion = rows[i], .friction_angle = rows[i + 1]};
    if (!std::isnan(rows[i + 2])) strength->tensile_strength = rows[i + 2];
  }
  return strengths;
}

BlockSystem read_system(hid_t file) {
  BlockSystem system;
  const Handle talus(check(H5Gopen2(file, "/Talus", H5P_DEFAULT), "holds no blocks"));
  system.joint_names = hdf5::read_strings(talus, "joints");
  system.strengths = read_strengths(talus);
  system.solids_volume = hdf5::read_number_attribute<double>(talus, "solids_volume");
  const auto names = hdf5::read_strings(talus, "blocks/name"), bodies = hdf5::read_strings(talus, "blocks/body");
  const auto reasons =
      holds(talus, "blocks/body_reason") ? hdf5::read_strings(talus, "blocks/body_reason") : std::vector<std::string>();
  const auto on_corners = holds(talus, "blocks/stands_on_corners")
                              ? hdf5::read_all<std::int32_t>(talus, "blocks/stands_on_corners")
                              : std::vector<std::int32_t>();
  const auto solid = hdf5::read_all<std::int32_t>(talus, "blocks/solid");
  const auto material = hdf5::read_all<std::int32_t>(talus, "blocks/material");
  const auto volume = hdf5::read_all<double>(talus, "blocks/volume");
  const auto node_counts = hdf5::read_all<std::int32_t>(talus, "blocks/nodes");
  const auto tetrahedron_counts = hdf5::read_all<std::int32_t>(talus, "blocks/tetrahedra");
  const auto triangle_counts = hdf5::read_all<std::int32_t>(talus, "blocks/triangles");
  const auto nodes = hdf5::read_all<double>(talus, "nodes");
  const auto tetrahedra = hdf5::read_all<std::int64_t>(file, "/VTKHDF/Connectivity");
  const auto triangles = hdf5::read_all<std::int64_t>(talus, "triangles");
  const auto triangle_joint = hdf5::read_all<std::int32_t>(talus, "triangle_joint");

  need_sum(node_counts, nodes.size(), 3, "the blocks' numbers of nodes are wrong");
  need_sum(tetrahedron_counts, tetrahedra.size(), 4, "the blocks' numbers of tetrahedra are wrong");
  need_sum(triangle_counts, triangles.size(), 3, "the blocks' numbers of triangles are wrong");
  need(triangle_joint.size() == triangles.size() / 3, "the triangles' joints are wrong");
  for (const std::int32_t one : triangle_joint)
    need(is_index_or_none(one, system.joint_names.size()), "the triangles' joints are wrong");

  std::int64_t first_node = 0;
  const std::int64_t *tetrahedron = tetrahedra.data(), *triangle = triangles.data();
  const std::int32_t* joint = triangle_joint.data();
  for (std::size_t b = 0; b < names.size(); ++b) {
    Block& block = system.blocks.emplace_back();
    block.name = names[b];
    block.solid = solid.at(b);
    block.material = material.at(b);
    block.body = body_kind(bodies.at(b));
    if (!reasons.empty()) block.body_reason = reasons.at(b);
    if (!on_corners.empty()) block.stands_on_corners = on_corners.at(b) != 0;
    block.volume = volume.at(b);
    for (int i = 0; i < node_counts.at(b); ++i)
      block.mesh.nodes.emplace_back(Eigen::Map<const Vec3>(&nodes.at(3 * (first_node + i))));
    for (int i = 0; i < tetrahedron_counts.at(b); ++i, tetrahedron += 4)
      block.mesh.tetrahedra.push_back(local_nodes<4>(tetrahedron, first_node, block.mesh.nodes.size()));
    for (int i = 0; i < triangle_counts.at(b); ++i, triangle += 3)
      block.surface.push_back({local_nodes<3>(triangle, first_node, block.mesh.nodes.size()), *joint++});
    first_node += node_counts[b];
  }
  return system;
}

std::vector<HistoryMonitor> read_history_monitors(hid_t file, const std::vector<std::string>& names) {
  std::vector<std::int32_t> stress(names.size(), 0);
  if (holds(file, "/Talus/monitor_stress")) stress = hdf5::read_all<std::int32_t>(file, "/Talus/monitor_stress");
  std::vector<HistoryMonitor> monitors;
  for (std::size_t m = 0; m < names.size(); ++m) monitors.push_back({names[m], stress.at(m) != 0});
  return monitors;
}

/// HDF5's own words say much to its makers alone: they stand in brackets.
std::string damaged(const std::exception& error) {
  return std::string("the file is damaged or was cut off (") + error.what() + ")";
}

InputError unreadable(const std::filesystem::path& file, const std::exception& error) {
  if (H5Fis_hdf5(file.c_str()) <= 0)
    return {file.string(), "is no results file, or its beginning is lost", "choose a results folder written by Talus"};
  return {file.string(), damaged(error), "copy it again from where it was computed, or solve the project again"};
}

/// The rows of a frame that has as many as it likes.
template <class Row, class Thing>
std::vector<Thing> read_list(const Table& table, const Table& ends, hsize_t frame, const Row& unknown) {
  std::int64_t begin = 0, end = 0;
  ends.read(&end, frame, 1);
  if (frame > 0) ends.read(&begin, frame - 1, 1);
  need(begin >= 0 && begin <= end && static_cast<hsize_t>(end) <= table.rows(), "the ends of its lists are wrong");
  std::vector<Row> rows(static_cast<std::size_t>(end - begin), unknown);
  table.read(rows.data(), static_cast<hsize_t>(begin), rows.size());
  std::vector<Thing> things;
  for (const Row& row : rows) things.push_back(restored(row));
  return things;
}

/// All who read a file in this program share its tables: HDF5 loses where a data set's pieces lie when it is opened a
/// second time and refreshed, and from then on all of them read zeros. Throws hdf5::Error.
std::shared_ptr<OpenResultFile> shared_file(const std::filesystem::path& path) {
  static std::map<std::pair<dev_t, ino_t>, std::weak_ptr<OpenResultFile>> open_files;
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) throw hdf5::Error("cannot be opened");
  std::weak_ptr<OpenResultFile>& known = open_files[{status.st_dev, status.st_ino}];
  std::shared_ptr<OpenResultFile> shared = known.lock();
  if (!shared) {
    shared = std::make_shared<OpenResultFile>();
    shared->file = open_file(path);
    known = shared;
  }
  return shared;
}

}  // namespace

struct ResultFileReader::State {
  std::filesystem::path path;
  hsize_t node_count = 0, tetrahedron_count = 0;
  std::size_t block_count = 0, joint_count = 0;
  std::shared_ptr<OpenResultFile> shared;

  Frame read(int number, double time) const;
};

Frame ResultFileReader::State::read(int number, double time) const {
  const auto row = static_cast<hsize_t>(number);
  const FrameTables& t = shared->tables;
  Frame frame;
  frame.time = time;
  t.index.read(&frame.index, row, 1);
  t.stage.read(&frame.stage, row, 1);
  frame.displacement.resize(node_count);
  frame.velocity.resize(node_count);
  frame.stress.resize(tetrahedron_count);
  t.displacement.read(frame.displacement.data(), row * node_count, node_count);
  t.velocity.read(frame.velocity.data(), row * node_count, node_count);
  t.stress.read(frame.stress.data(), row * tetrahedron_count, tetrahedron_count);

  frame.contacts = read_list<StoredContact, ContactSample>(t.contacts, t.contact_ends, row, unknown_contact());
  for (const ContactSample& contact : frame.contacts) {
    for (const int block : contact.blocks) need(is_index(block, block_count), "a contact's block is not there");
    need(is_index_or_none(contact.joint, joint_count), "a contact's joint is not there");
    need(contact.state <= ContactState::slip, "a contact's state is not known");
    need(contact.bond <= Bond::broken, "a contact's bond is not known");
  }
  if (t.has_sleep) {
    std::vector<std::int8_t> sleepers(block_count);
    t.asleep.read(sleepers.data(), row * block_count, block_count);
    if (std::ranges::none_of(sleepers, [](std::int8_t flag) { return flag < 0; }))
      frame.asleep.assign(sleepers.begin(), sleepers.end());
  }
  if (!t.has_motions) return frame;
  frame.motions = read_list<StoredMotion, MotionClass>(t.motions, t.motion_ends, row, StoredMotion{});
  need(frame.motions.empty() || frame.motions.size() == block_count, "the blocks' motions are not whole");
  for (const MotionClass& motion : frame.motions)
    need(motion.mode <= MotionMode::sliding_and_torsional, "a motion is not known");
  return frame;
}

ResultFileReader::ResultFileReader(const std::filesystem::path& file) : state_(std::make_unique<State>()) {
  const std::lock_guard lock(hdf5::library_mutex());
  try {
    state_->path = file;
    state_->shared = shared_file(file);
    const Handle& opened = state_->shared->file;
    system = read_system(opened);
    state_->block_count = system.blocks.size();
    state_->joint_count = system.joint_names.size();
    for (const Block& block : system.blocks) {
      state_->node_count += block.mesh.nodes.size();
      state_->tetrahedron_count += block.mesh.tetrahedra.size();
    }
    project_name = hdf5::read_strings(opened, "/Talus/project").at(0);
    stage_names = hdf5::read_strings(opened, "/Talus/stages");
    monitor_names = hdf5::read_strings(opened, "/Talus/monitors");
    history_monitors = read_history_monitors(opened, monitor_names);
    const Table times(opened, "/VTKHDF/Steps/Values", H5T_NATIVE_DOUBLE);
    frame_times.resize(times.rows());
    times.read(frame_times.data(), 0, times.rows());
    state_->shared->look_again();
  } catch (const std::exception& error) {
    state_.reset();
    throw unreadable(file, error);
  }
}

ResultFileReader::~ResultFileReader() {
  const std::lock_guard lock(hdf5::library_mutex());
  state_.reset();
}

Frame ResultFileReader::frame(int number) const {
  const double time = frame_times.at(static_cast<std::size_t>(number));
  const std::lock_guard lock(hdf5::library_mutex());
  try {
    return state_->read(number, time);
  } catch (const hdf5::Error& error) {
    throw InputError(state_->path.string(), "frame " + std::to_string(number) + " cannot be read: " + damaged(error),
                     "look at the other frames, or solve the project again");
  }
}

}  // namespace talus
