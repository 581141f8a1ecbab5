/// talus-mesher: the program that runs gmsh for Talus, so that a crash in it or a cancelled wait ends nothing else.
/// Reads one job from descriptor 0 and answers there with progress, blocks, and an end or an error (mesher_job.hpp).

#include <gmsh.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>

#include "base/error.hpp"
#include "geometry/mesher/block_names.hpp"
#include "geometry/mesher/overlap.hpp"
#include "geometry/mesher/tet_mesher.hpp"

namespace talus {
namespace {

constexpr int channel = 0;

void receive_exactly(char* into, std::size_t size) {
  while (size > 0) {
    const ssize_t count = read(channel, into, size);
    if (count <= 0) throw std::runtime_error("the job ended too early");
    into += count;
    size -= static_cast<std::size_t>(count);
  }
}

void send_exactly(const char* from, std::size_t size) {
  while (size > 0) {
    const ssize_t count = write(channel, from, size);
    if (count <= 0) _exit(1);  // nobody listens any more
    from += count;
    size -= static_cast<std::size_t>(count);
  }
}

template <class Message>
void send_message(MessageKind kind, const Message& message) {
  const std::string bytes = to_bytes(message);
  const MessageHeader header{kind, bytes.size()};
  send_exactly(reinterpret_cast<const char*>(&header), sizeof header);
  send_exactly(bytes.data(), bytes.size());
}

MesherJob receive_job() {
  MessageHeader header;
  receive_exactly(reinterpret_cast<char*>(&header), sizeof header);
  std::string bytes(header.size, '\0');
  receive_exactly(bytes.data(), bytes.size());
  return from_bytes<MesherJob>(bytes);
}

void report(double fraction, std::string_view what) {
  send_message(MessageKind::progress, MesherProgress{fraction, std::string(what)});
}

MesherBlock finished_block(const ImportedModel& model, const CutBlock& cut, const NamedBlock& named,
                           MeshedShape shape) {
  for (Vec3& node : shape.nodes) node += model.origin;
  std::vector<int> joints = std::move(shape.triangle_joints);
  return {named.name,
          cut.solid,
          named.block_override,
          cut.volume,
          std::move(shape.nodes),
          std::move(shape.tetrahedra),
          std::move(shape.triangles),
          std::move(joints)};
}

/// From the cut model to finished blocks, sent one by one.
void mesh_blocks(const ImportedModel& model, const CutModel& cut, const std::vector<NamedBlock>& names,
                 double share_done) {
  std::vector<double> sizes;
  for (const NamedBlock& block : names) sizes.push_back(block.mesh_size);
  report(share_done, "meshing the surfaces of " + std::to_string(cut.blocks.size()) + " blocks");
  const std::vector<SurfaceMesh> surfaces = mesh_surfaces(cut, sizes);
  for (std::size_t b = 0; b < cut.blocks.size(); ++b) {
    const std::string place = "block " + names[b].name;
    const double fraction = static_cast<double>(b) / static_cast<double>(cut.blocks.size());
    report(share_done + (1 - share_done) * fraction,
           "meshing " + place + " (" + std::to_string(b + 1) + " of " + std::to_string(cut.blocks.size()) + ")");
    MeshedShape shape = fill_with_tetrahedra(surfaces[b], sizes[b], cut.blocks[b].volume, place);
    send_message(MessageKind::block, finished_block(model, cut.blocks[b], names[b], std::move(shape)));
  }
}

void work(const MesherJob& job) {
  constexpr double imported = 0.05, cut_done = 0.2;  // shares of the whole
  report(0, "importing solids");
  gmsh::model::add("rock");
  const ImportedModel model = import_solids(job.solids);
  check_no_overlap(model, job.solids);
  const CutModel cut = cut_solids(job, model, [](double fraction, std::string_view what) {
    report(imported + (cut_done - imported) * fraction, what);
  });
  mesh_blocks(model, cut, name_blocks(job, model, cut), cut_done);
  MesherEnd end;
  for (const ImportedSolid& solid : model.solids) end.solids_volume += solid.volume;
  send_message(MessageKind::end, end);
}

void run() {
  try {
    const MesherJob job = receive_job();
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    // An error in the threads of surface meshing would end the process; the checks of each mesh see it as well.
    gmsh::option::setNumber("General.AbortOnError", 0);
    work(job);
  } catch (const InputError& error) {
    send_message(MessageKind::error, MesherError{error.place(), error.problem(), error.remedy()});
  } catch (const std::string& error) {
    send_message(MessageKind::fault, MesherFault{"gmsh: " + error});
  } catch (const std::exception& error) {
    send_message(MessageKind::fault, MesherFault{error.what()});
  }
}

}  // namespace
}  // namespace talus

int main() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  talus::run();
  _exit(0);  // OpenCASCADE's and gmsh's own tidying up is slow and of no use
}
