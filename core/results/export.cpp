#include "results/export.hpp"

#include <fstream>
#include <functional>

#include "base/error.hpp"
#include "base/line_attitude.hpp"
#include "model/number_text.hpp"
#include "results/history.hpp"
#include "results/steps.hpp"
#include "results/text_table.hpp"
#include "results/vtu.hpp"

namespace talus {

namespace fs = std::filesystem;

namespace {

void prepare(const fs::path& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) throw InputError(folder.string(), "cannot be made: " + problem.message(), "choose another --out");
  if (!fs::is_empty(folder))
    throw InputError(folder.string(), "is not empty", "choose another --out, or empty it first");
}

/// "nodes_00012.csv"
std::string numbered(const std::string& name, std::size_t frame, const std::string& ending) {
  const std::string number = std::to_string(frame);
  return name + '_' + std::string(number.size() < 5 ? 5 - number.size() : 0, '0') + number + ending;
}

void write_file(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  write(stream);
  stream.close();
  if (!stream) throw InputError(file.string(), "cannot be written", "free space on the disk or choose another --out");
}

/// Calls `write(number, frame)` for every frame of the results.
void for_each_frame(const ResultReader& results, Progress& progress,
                    const std::function<void(std::size_t, const Frame&)>& write) {
  const std::size_t count = results.frame_times().size();
  for (std::size_t i = 0; i < count; ++i) {
    if (progress.cancelled()) throw Cancelled{};
    progress.report(static_cast<double>(i) / static_cast<double>(count),
                    "frame " + std::to_string(i + 1) + " of " + std::to_string(count));
    write(i, results.frame(static_cast<int>(i)));
  }
}

void write_blocks(std::ostream& stream, const BlockSystem& system) {
  stream << "block,name,body,volume [m3],nodes,tetrahedra\n";
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    stream << b << ',' << csv_field(block.name) << ',' << to_string(block.body) << ',' << number_text(block.volume)
           << ',' << block.mesh.nodes.size() << ',' << block.mesh.tetrahedra.size() << '\n';
  }
}

void write_motions(std::ostream& stream, const BlockSystem& system, const Frame& frame) {
  const MotionNames names = motion_names(system);
  stream << "block,name,mode,motion,trend [deg],plunge [deg],share of rotation\n";
  for (std::size_t b = 0; b < frame.motions.size(); ++b) {
    const MotionClass& motion = frame.motions[b];
    const bool goes = !motion.direction.isZero();
    const LineAttitude attitude = attitude_of(motion.direction);
    stream << b << ',' << csv_field(names.blocks[b]) << ',' << to_string(motion.mode) << ','
           << csv_field(motion_text(motion, names)) << ',' << (goes ? csv_line({attitude.trend, attitude.plunge}) : ",")
           << ',' << number_text(motion.rotation_share) << '\n';
  }
}

void write_nodes(std::ostream& stream, const BlockSystem& system, const Frame& frame) {
  stream << "block,x [m],y [m],z [m],displacement.x [m],displacement.y [m],displacement.z [m],velocity.x [m/s],"
            "velocity.y [m/s],velocity.z [m/s]\n";
  std::size_t n = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b)
    for (const Vec3& node : system.blocks[b].mesh.nodes) {
      const Vec3 &u = frame.displacement[n], &v = frame.velocity[n], x = node + u;
      stream << b << ',' << csv_line({x.x(), x.y(), x.z(), u.x(), u.y(), u.z(), v.x(), v.y(), v.z()}) << '\n';
      ++n;
    }
}

void write_tetrahedra(std::ostream& stream, const BlockSystem& system, const Frame& frame) {
  stream << "block,node 1,node 2,node 3,node 4,stress.xx [Pa],stress.yy [Pa],stress.zz [Pa],stress.xy [Pa],"
            "stress.yz [Pa],stress.zx [Pa]\n";
  std::size_t t = 0, first_node = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    for (const auto& tetrahedron : system.blocks[b].mesh.tetrahedra) {
      stream << b;
      for (const int node : tetrahedron) stream << ',' << first_node + static_cast<std::size_t>(node);
      const Voigt& stress = frame.stress[t++];
      stream << ',' << csv_line({stress.begin(), stress.end()}) << '\n';
    }
    first_node += system.blocks[b].mesh.nodes.size();
  }
}

std::string_view state_word(ContactState state) {
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

void write_contacts(std::ostream& stream, const BlockSystem& system, const Frame& frame) {
  stream << "block 1,block 2,joint,state,x [m],y [m],z [m],normal.x,normal.y,normal.z,normal force [N],"
            "shear force.x [N],shear force.y [N],shear force.z [N],area [m2]\n";
  for (const ContactSample& contact : frame.contacts) {
    const Vec3 &x = contact.position, &n = contact.normal, &f = contact.shear_force;
    const bool named = contact.joint >= 0 && contact.joint < static_cast<int>(system.joint_names.size());
    stream << contact.blocks[0] << ',' << contact.blocks[1] << ','
           << (named ? csv_field(system.joint_names[contact.joint]) : "") << ',' << state_word(contact.state) << ','
           << csv_line(
                  {x.x(), x.y(), x.z(), n.x(), n.y(), n.z(), contact.normal_force, f.x(), f.y(), f.z(), contact.area})
           << '\n';
  }
}

}  // namespace

void export_vtu(const ResultReader& results, const fs::path& folder, Progress& progress) {
  prepare(folder);
  std::string collection =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for_each_frame(results, progress, [&](std::size_t i, const Frame& frame) {
    const std::string name = numbered("frame", i, ".vtu");
    write_file(folder / name, [&](std::ostream& stream) { write_vtu(stream, results.system(), frame); });
    collection +=
        "<DataSet timestep=\"" + number_text(frame.time) + "\" group=\"\" part=\"0\" file=\"" + name + "\"/>\n";
  });
  write_file(folder / "frames.pvd",
             [&](std::ostream& stream) { stream << collection << "</Collection>\n</VTKFile>\n"; });
}

void export_csv(const ResultReader& results, const fs::path& folder, Progress& progress) {
  prepare(folder);
  const BlockSystem& system = results.system();
  write_file(folder / "blocks.csv", [&](std::ostream& stream) { write_blocks(stream, system); });
  TextTableWriter history(folder / "history.csv", history_header(results.history_monitors()));
  for (const HistoryRow& row : results.history()) history.add(to_columns(row));
  TextTableWriter steps(folder / "steps.csv", steps_header());
  for (const StepReport& step : results.steps()) steps.add(to_columns(step));

  TextTableWriter frames(folder / "frames.csv", {"frame", "time [s]", "stage"});
  for_each_frame(results, progress, [&](std::size_t i, const Frame& frame) {
    frames.add({static_cast<double>(i), frame.time, static_cast<double>(frame.stage)});
    const auto table = [&](const std::string& name, auto write) {
      write_file(folder / numbered(name, i, ".csv"), [&](std::ostream& stream) { write(stream, system, frame); });
    };
    table("nodes", write_nodes);
    table("tetrahedra", write_tetrahedra);
    table("contacts", write_contacts);
    table("motions", write_motions);
  });
}

}  // namespace talus
