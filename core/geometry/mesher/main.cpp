/// talus-mesher: the program that runs gmsh, CGAL and GDAL for Talus, so that a crash in them or a cancelled wait ends
/// nothing else. Reads one job from descriptor 0, answers there with what cutting made of it, and, told how finely to
/// mesh, with blocks, or with what its solids look like; then with an end or an error (mesher_job.hpp).

#include <gmsh.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "base/error.hpp"
#include "geometry/mesher/block_names.hpp"
#include "geometry/mesher/overlap.hpp"
#include "geometry/mesher/solid_views.hpp"
#include "geometry/mesher/tet_mesher.hpp"

namespace talus {
namespace {

constexpr int channel = 0;

void receive_exactly(char* into, std::size_t size) {
  while (size > 0) {
    const ssize_t count = read(channel, into, size);
    if (count <= 0) throw std::runtime_error("a message ended too early");
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

struct Received {
  MessageKind kind;
  std::string bytes;
};

Received receive_message() {
  MessageHeader header;
  receive_exactly(reinterpret_cast<char*>(&header), sizeof header);
  Received received{header.kind, std::string(header.size, '\0')};
  receive_exactly(received.bytes.data(), received.bytes.size());
  return received;
}

void report(double fraction, std::string_view what) {
  send_message(MessageKind::progress, MesherProgress{fraction, std::string(what)});
}

MesherBlock finished_block(const ImportedModel& model, const CutBlock& cut, MeshedShape shape) {
  for (Vec3& node : shape.nodes) node += model.origin;
  return {cut.volume, std::move(shape.nodes), std::move(shape.tetrahedra), std::move(shape.triangles),
          std::move(shape.triangle_joints)};
}

/// Edges of a block with flat faces are shorter than the diagonal of its solid. One size for all that are coarse:
/// neighbours then have equal triangles on the joint between them. Curved faces need the usual size to keep their
/// shape.
double coarsest_size_of(const CutBlock& cut, const ImportedSolid& solid, double usual_size) {
  const bool flat =
      std::all_of(cut.facets.begin(), cut.facets.end(), [](const auto& facet) { return facet.second.plane >= 0; });
  return flat ? solid.bounds.diagonal().norm() : usual_size;
}

MesherCutModel cut_model(const ImportedModel& model, const CutModel& cut, const std::vector<NamedBlock>& names) {
  MesherCutModel told;
  Eigen::AlignedBox3d bounds;
  for (const ImportedSolid& solid : model.solids) bounds.extend(solid.bounds);
  told.extent = bounds.sizes();
  for (std::size_t b = 0; b < names.size(); ++b) {
    const CutBlock& block = cut.blocks[b];
    const ImportedSolid& solid = model.solids[static_cast<std::size_t>(block.solid)];
    told.blocks.push_back({names[b].name, block.solid, names[b].block_override, names[b].mesh_size,
                           coarsest_size_of(block, solid, names[b].mesh_size)});
  }
  return told;
}

/// From the cut model to finished blocks, sent one by one.
void mesh_blocks(const ImportedModel& model, const CutModel& cut, const std::vector<NamedBlock>& names,
                 const std::vector<double>& sizes, double share_done) {
  report(share_done, "meshing the surfaces of " + std::to_string(cut.blocks.size()) + " blocks");
  const std::vector<SurfaceMesh> surfaces = mesh_surfaces(cut, sizes);
  for (std::size_t b = 0; b < cut.blocks.size(); ++b) {
    const std::string place = "block " + names[b].name;
    const double fraction = static_cast<double>(b) / static_cast<double>(cut.blocks.size());
    report(share_done + (1 - share_done) * fraction,
           "meshing " + place + " (" + std::to_string(b + 1) + " of " + std::to_string(cut.blocks.size()) + ")");
    MeshedShape shape = fill_with_tetrahedra(surfaces[b], sizes[b], cut.blocks[b].volume, place);
    send_message(MessageKind::block, finished_block(model, cut.blocks[b], std::move(shape)));
  }
}

/// The solids as they come. What the program itself knows, polyhedra, is left empty.
void look(const MesherJob& job) {
  gmsh::model::add("rock");
  const ImportedModel model = import_solids(job.solids, ImportPurpose::look, report);
  for (std::size_t i = 0; i < job.solids.size(); ++i) {
    const bool known = !job.solids[i].polyhedron.faces.empty();
    send_message(MessageKind::surface,
                 known ? SolidSurface{} : surface_of(job.solids[i], model.solids[i], model.origin));
  }
  send_message(MessageKind::end, MesherEnd{});
}

void work(const MesherJob& job) {
  constexpr double imported = 0.05, cut_done = 0.2;  // shares of the whole
  gmsh::model::add("rock");
  const ImportedModel model = import_solids(job.solids, ImportPurpose::cut, [](double fraction, std::string_view what) {
    report(imported * fraction, what);
  });
  check_no_overlap(model, job.solids);
  const CutModel cut = cut_solids(job, model, [](double fraction, std::string_view what) {
    report(imported + (cut_done - imported) * fraction, what);
  });
  const std::vector<NamedBlock> names = name_blocks(job, model, cut);
  send_message(MessageKind::cut, cut_model(model, cut, names));
  mesh_blocks(model, cut, names, from_bytes<MesherSizes>(receive_message().bytes).sizes, cut_done);
  MesherEnd end;
  for (const ImportedSolid& solid : model.solids) end.solids_volume += solid.volume;
  send_message(MessageKind::end, end);
}

void run() {
  try {
    const Received order = receive_message();
    const auto job = from_bytes<MesherJob>(order.bytes);
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    // An error in the threads of surface meshing would end the process; the checks of each mesh see it as well.
    gmsh::option::setNumber("General.AbortOnError", 0);
    order.kind == MessageKind::look ? look(job) : work(job);
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
