#include "export/export.hpp"

#include <cmath>
#include <ostream>

#include "base/line_attitude.hpp"
#include "export/export_folder.hpp"
#include "measures/block_travel.hpp"
#include "model/number_text.hpp"
#include "results/history.hpp"
#include "results/steps.hpp"
#include "results/text_table.hpp"

namespace talus {

namespace fs = std::filesystem;

namespace {

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

/// Its strength in three columns; empty ones of results that do not tell of it.
std::string strength_columns(const ContactSample& contact) {
  if (std::isnan(contact.friction)) return ",,";
  constexpr std::string_view bonds[] = {"none", "whole", "broken"};
  return csv_line({contact.friction, contact.cohesion}) + ',' +
         std::string(bonds[static_cast<std::size_t>(contact.bond)]);
}

void write_contacts(std::ostream& stream, const BlockSystem& system, const Frame& frame) {
  stream << "block 1,block 2,joint,state,x [m],y [m],z [m],normal.x,normal.y,normal.z,normal force [N],"
            "shear force.x [N],shear force.y [N],shear force.z [N],area [m2],friction,cohesion [Pa],bond\n";
  for (const ContactSample& contact : frame.contacts) {
    const Vec3 &x = contact.position, &n = contact.normal, &f = contact.shear_force;
    const bool named = contact.joint >= 0 && contact.joint < static_cast<int>(system.joint_names.size());
    stream << contact.blocks[0] << ',' << contact.blocks[1] << ','
           << (named ? csv_field(system.joint_names[contact.joint]) : "") << ',' << state_word(contact.state) << ','
           << csv_line(
                  {x.x(), x.y(), x.z(), n.x(), n.y(), n.z(), contact.normal_force, f.x(), f.y(), f.z(), contact.area})
           << ',' << strength_columns(contact) << '\n';
  }
}

void write_travels(std::ostream& stream, const BlockSystem& system, const Frame& frame) {
  stream << "block,name,x [m],y [m],z [m],displacement.x [m],displacement.y [m],displacement.z [m],velocity.x [m/s],"
            "velocity.y [m/s],velocity.z [m/s],rotation [deg]\n";
  for (const BlockTravel& travel : block_travels(system, frame)) {
    const Vec3 &x = travel.centroid, &u = travel.displacement, &v = travel.velocity;
    stream << travel.block << ',' << csv_field(system.blocks[static_cast<std::size_t>(travel.block)].name) << ','
           << csv_line({x.x(), x.y(), x.z(), u.x(), u.y(), u.z(), v.x(), v.y(), v.z(), travel.turn()}) << '\n';
  }
}

void write_events(std::ostream& stream, const std::vector<Event>& events) {
  stream << "time [s],event\n";
  for (const Event& event : events) stream << number_text(event.time) << ',' << csv_field(event.what) << '\n';
}

}  // namespace

void export_csv(const ResultReader& results, std::span<const int> frames, const fs::path& folder, Progress& progress) {
  prepare_export_folder(folder);
  const BlockSystem& system = results.system();
  write_export_file(folder / "blocks.csv", [&](std::ostream& stream) { write_blocks(stream, system); });
  if (const auto report = results.report())
    write_export_file(folder / "events.csv", [&](std::ostream& stream) { write_events(stream, report->events); });
  TextTableWriter history(folder / "history.csv", history_header(results.history_monitors()));
  for (const HistoryRow& row : results.history()) history.add(to_columns(row));
  TextTableWriter steps(folder / "steps.csv", steps_header());
  for (const StepReport& step : results.steps()) steps.add(to_columns(step));

  TextTableWriter times(folder / "frames.csv", {"frame", "time [s]", "stage"});
  for_each_frame(results, frames, progress, [&](const Frame& frame) {
    times.add({static_cast<double>(frame.index), frame.time, static_cast<double>(frame.stage)});
    const auto table = [&](const std::string& name, auto write) {
      write_export_file(folder / numbered_name(name, frame.index, ".csv"),
                        [&](std::ostream& stream) { write(stream, system, frame); });
    };
    table("nodes", write_nodes);
    table("tetrahedra", write_tetrahedra);
    table("contacts", write_contacts);
    table("motions", write_motions);
    table("travels", write_travels);
  });
}

}  // namespace talus
