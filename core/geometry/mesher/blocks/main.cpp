/// talus-mesher: the program that runs gmsh, CGAL and GDAL for Talus, so that a crash in them or a cancelled wait ends
/// nothing else. Reads a job from descriptor 0, and others from sockets that come by another (waiting_mesher.hpp);
/// answers each with what cutting made of it, and, told how finely to mesh, with blocks, or with what its solids look
/// like; then with an end or an error (mesher_job.hpp).

#include <fcntl.h>
#include <gmsh.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <iterator>
#include <set>

#include "base/error.hpp"
#include "base/socket.hpp"
#include "geometry/mesher/blocks/kept_blocks.hpp"
#include "geometry/mesher/blocks/splinters.hpp"
#include "geometry/mesher/cells/cell_mesher.hpp"
#include "geometry/mesher/cells/facet_outlines.hpp"
#include "geometry/mesher/cut_estimate.hpp"
#include "geometry/mesher/occ_volumes.hpp"
#include "geometry/mesher/overlap.hpp"
#include "geometry/mesher/solid_views.hpp"
#include "geometry/mesher/tet_mesher.hpp"
#include "geometry/splinters_found.hpp"
#include "mesh/size_field.hpp"
#include "model/about_text.hpp"

namespace talus {
namespace {

/// The socket of the job.
Socket& channel() {
  static Socket taken;
  return taken;
}

/// From standard input gmsh reads whether a mesh is meant to be as large as it will be, and waited for ever: the answer
/// is no.
void answer_no_to_gmsh() {
  constexpr std::string_view no = "0\n0\n0\n0\n";
  int answers[2];
  if (pipe(answers) != 0 || write(answers[1], no.data(), no.size()) < 0) _exit(1);
  dup2(answers[0], STDIN_FILENO);
  close(answers[0]);
  close(answers[1]);
}

void receive_exactly(char* into, std::size_t size) {
  while (size > 0) {
    const std::size_t count = channel().read(into, size);
    if (count == 0) throw std::runtime_error("a message ended too early");
    into += count;
    size -= count;
  }
}

void send_exactly(std::string_view bytes) {
  if (!channel().send(bytes)) _exit(1);  // nobody listens any more
}

template <class Message>
void send_message(MessageKind kind, const Message& message) {
  const std::string bytes = to_bytes(message);
  const MessageHeader header = header_of(kind, bytes);
  send_exactly({reinterpret_cast<const char*>(&header), sizeof header});
  send_exactly(bytes);
}

struct Received {
  MessageKind kind;
  std::string bytes;
};

Received receive_message(MessageHeader header) {
  if (!is_understood(header)) throw std::runtime_error("the program is of another version");
  Received received{header.kind, std::string(header.size, '\0')};
  receive_exactly(received.bytes.data(), received.bytes.size());
  return received;
}

Received receive_message() {
  MessageHeader header;
  receive_exactly(reinterpret_cast<char*>(&header), sizeof header);
  return receive_message(header);
}

void report(double fraction, std::string_view what) {
  send_message(MessageKind::progress, MesherProgress{fraction, std::string(what)});
}

MesherBlock finished_block(const ImportedModel& model, const CutBlock& cut, MeshedShape shape, std::uint64_t key) {
  for (Vec3& node : shape.nodes) node += model.origin;
  return {key,
          false,
          cut.volume,
          std::move(shape.nodes),
          std::move(shape.tetrahedra),
          std::move(shape.triangles),
          std::move(shape.triangle_joints)};
}

/// Refinements that say a size somewhere in a box; both relative to the model's origin.
std::vector<MeshRefinement> reaching(const std::vector<MeshRefinement>& refinements, const Eigen::AlignedBox3d& box) {
  std::vector<MeshRefinement> found;
  std::copy_if(refinements.begin(), refinements.end(), std::back_inserter(found),
               [&](const MeshRefinement& one) { return box.exteriorDistance(box_of(one)) <= 2 * one.radius; });
  return found;
}

/// Edges of a block with flat faces are shorter than the diagonal of its solid. One size for all that are coarse:
/// neighbours then have equal triangles on the joint between them. Curved faces need the usual size to keep their
/// shape.
double coarsest_size_of(const CutBlock& cut, const ImportedSolid& solid, double usual_size) {
  const bool flat = std::all_of(cut.facets.begin(), cut.facets.end(),
                                [](const auto& facet) { return facet.second.origin.plane >= 0; });
  return flat ? solid.bounds.diagonal().norm() : usual_size;
}

int corners_of(const CutBlock& block, const CutModel& cut) {
  return block.cells.empty() ? corner_count(block.volume_tags) : corner_count(cut.cells.at(block.solid), block.cells);
}

MesherCutModel cut_model(const ImportedModel& model, const CutModel& cut, const KeptBlocks& kept) {
  MesherCutModel told;
  Eigen::AlignedBox3d bounds;
  for (const ImportedSolid& solid : model.solids) {
    bounds.extend(solid.bounds);
    told.solids_volume += solid.volume;
  }
  told.extent = bounds.sizes();
  told.excavated_volume = kept.excavated_volume;
  told.splinters = kept.splinters;
  told.endings = cut.endings;
  for (const NamedBlock& block : kept.blocks) {
    const ImportedSolid& solid = model.solids[static_cast<std::size_t>(block.shape.solid)];
    const Eigen::AlignedBox3d& box = block.shape.bounds;
    told.blocks.push_back({block.name, block.shape.solid, block.block_override, block.mesh_size,
                           coarsest_size_of(block.shape, solid, block.mesh_size), !block.shape.cells.empty(),
                           block.shape.volume, block.shape.area(), box.min() + model.origin, box.max() + model.origin,
                           corners_of(block.shape, cut)});
  }
  return told;
}

/// Relative to the model's origin.
std::vector<MeshRefinement> refinements_of(const MesherJob& job, const ImportedModel& model) {
  std::vector<MeshRefinement> refinements(job.refinements.begin(), job.refinements.end());
  for (MeshRefinement& refinement : refinements) {
    refinement.at -= model.origin;
    for (Vec3& corner : refinement.face) corner -= model.origin;
  }
  return refinements;
}

/// Of all that filling a surface depends on, and of where the model lies. Never 0.
std::uint64_t key_of(SurfaceMesh surface, double size, const std::vector<MeshRefinement>& nearby, double volume,
                     Vec3 origin) {
  ByteWriter all;
  all(surface.nodes, surface.triangles, size, volume, origin);
  for (FacetOrigin& facet : surface.origins) all(facet.joint);
  for (MeshRefinement one : nearby) all(one.at, one.radius, one.size, one.face);
  return std::max<std::uint64_t>(1, std::hash<std::string>()(all.bytes()));
}

/// How a block is meshed, one after the other.
class BlockMesher {
 public:
  BlockMesher(const ImportedModel& model, const CutModel& cut, const std::vector<NamedBlock>& blocks,
              const MesherCutModel& told, const MesherSizes& sizes, const std::vector<MeshRefinement>& refinements)
      : model_(model), cut_(cut), blocks_(blocks), told_(told), sizes_(sizes.sizes), refinements_(refinements) {
    known_.insert(sizes.known.begin(), sizes.known.end());
    surfaces_ = mesh_surfaces(blocks, cut.planes, sizes_, refinements);
  }

  MesherBlock mesh(std::size_t index) const {
    try {
      return meshed(index);
    } catch (const TouchesItself& error) {
      throw InputError(error.place(), error.problem() + " at " + coordinates(error.at() + model_.origin),
                       error.remedy());
    }
  }

 private:
  MesherBlock meshed(std::size_t index) const {
    const std::string place = "block " + blocks_[index].name;
    const CutBlock& shape = blocks_[index].shape;
    const auto [size, refined] = sizes_[index];
    if (!shape.cells.empty() && !refined && size >= told_.blocks[index].coarsest_size)
      return finished_block(model_, shape, coarse_mesh(cut_.cells.at(shape.solid), shape.cells, place), 0);
    const auto nearby = refined ? reaching(refinements_, shape.bounds) : std::vector<MeshRefinement>();
    const SurfaceMesh surface = shape.cells.empty()
                                    ? surfaces_[index]
                                    : fine_surface(cut_.cells.at(shape.solid), shape.cells, {size, nearby}, place);
    const std::uint64_t key = key_of(surface, size, nearby, shape.volume, model_.origin);
    if (known_.contains(key)) return {key, true, shape.volume, {}, {}, {}, {}};
    return finished_block(model_, shape, fill_with_tetrahedra(surface, size, nearby, shape.volume, place), key);
  }

  const ImportedModel& model_;
  const CutModel& cut_;
  const std::vector<NamedBlock>& blocks_;
  const MesherCutModel& told_;
  const std::vector<MesherSize>& sizes_;
  const std::vector<MeshRefinement>& refinements_;
  std::set<std::uint64_t> known_;
  std::vector<SurfaceMesh> surfaces_;
};

/// From the blocks' shapes to finished blocks, sent one by one.
void mesh_blocks(const ImportedModel& model, const CutModel& cut, const std::vector<NamedBlock>& blocks,
                 const MesherCutModel& told, const MesherSizes& sizes, const std::vector<MeshRefinement>& refinements,
                 double share_done) {
  report(share_done, "meshing the surfaces of " + std::to_string(blocks.size()) + " blocks");
  const BlockMesher mesher(model, cut, blocks, told, sizes, refinements);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const double fraction = static_cast<double>(b) / static_cast<double>(blocks.size());
    report(share_done + (1 - share_done) * fraction, "meshing block " + blocks[b].name + " (" + std::to_string(b + 1) +
                                                         " of " + std::to_string(blocks.size()) + ")");
    send_message(MessageKind::block, mesher.mesh(b));
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

/// Nothing where cutting takes no time to speak of.
std::string words_of(const MesherCutAhead& ahead) {
  constexpr double a_while = 3;  // s
  if (ahead.seconds < a_while) return {};
  return ", about " + about_text(ahead.blocks) + " blocks in some " + about_text(ahead.seconds) + " s";
}

void work(const MesherJob& job) {
  constexpr double imported = 0.05, cut_done = 0.2;  // shares of the whole
  gmsh::model::add("rock");
  const ImportedModel model = import_solids(job.solids, ImportPurpose::cut, [](double fraction, std::string_view what) {
    report(imported * fraction, what);
  });
  check_no_overlap(model, job.solids);
  report(imported, "foreseeing what the cuts come to");
  const MesherCutAhead ahead = cut_ahead(job, model);
  send_message(MessageKind::ahead, ahead);
  const CutModel cut = cut_solids(job, model, [&](double fraction, std::string_view what) {
    report(imported + (cut_done - imported) * fraction, std::string(what) + words_of(ahead));
  });
  const KeptBlocks kept = keep_blocks(job, model, cut);
  const MesherCutModel told = cut_model(model, cut, kept);
  send_message(MessageKind::cut, told);
  mesh_blocks(model, cut, kept.blocks, told, from_bytes<MesherSizes>(receive_message().bytes),
              refinements_of(job, model), cut_done);
  send_message(MessageKind::end, MesherEnd{});
}

MesherError message_of(const InputError& error) { return {error.place(), error.problem(), error.remedy(), {}}; }

MesherError message_of(const SplintersFound& error) {
  MesherError message = message_of(static_cast<const InputError&>(error));
  for (const Splinter& splinter : error.splinters()) message.splinters.push_back({splinter});
  return message;
}

/// The job whose message begins so.
void run(const MessageHeader& header) {
  try {
    const Received order = receive_message(header);
    const auto job = from_bytes<MesherJob>(order.bytes);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    // An error in the threads of surface meshing would end the process; the checks of each mesh see it as well.
    gmsh::option::setNumber("General.AbortOnError", 0);
    order.kind == MessageKind::look ? look(job) : work(job);
  } catch (const SplintersFound& error) {
    send_message(MessageKind::error, message_of(error));
  } catch (const InputError& error) {
    send_message(MessageKind::error, message_of(error));
  } catch (const std::string& error) {
    send_message(MessageKind::fault, MesherFault{"gmsh: " + error});
  } catch (const std::exception& error) {
    send_message(MessageKind::fault, MesherFault{error.what()});
  }
}

/// A job is done in a process of its own: a cancelled wait or a crash ends that alone.
class Jobs {
 public:
  /// The first comes by standard input, and with it a socket by which come those of the others, each of which is
  /// answered with a byte. Until that is closed.
  void serve() {
    Socket orders = begin_first();
    std::signal(SIGCHLD, [](int) {});  // ends poll, so that who has ended is waited for
    while (orders.descriptor() >= 0) {
      for (pid_t ended = 0; (ended = waitpid(-1, nullptr, WNOHANG)) > 0;) at_work_.erase(ended);
      pollfd watched{orders.descriptor(), POLLIN, 0};
      if (poll(&watched, 1, -1) < 0) continue;
      char order = 0;
      auto received = orders.read_with(&order, 1);
      if (received.first == 0) break;
      begin(std::move(received.second), orders);
      orders.send("b");  // it is begun
    }
    if (orders.descriptor() >= 0)
      for (const pid_t one : at_work_) kill(one, SIGKILL);
    while (wait(nullptr) > 0) {
    }
  }

 private:
  Socket begin_first() {
    Socket job(fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
    MessageHeader header;
    auto received = job.read_with(reinterpret_cast<char*>(&header), sizeof header);
    if (received.first == 0) _exit(0);  // nobody asks
    fork_for(std::move(job), received.second, [&] {
      receive_exactly(reinterpret_cast<char*>(&header) + received.first, sizeof header - received.first);
      run(header);
    });
    answer_no_to_gmsh();  // which leaves the job's socket to who does it
    return std::move(received.second);
  }

  void begin(Socket job, Socket& orders) {
    fork_for(std::move(job), orders, [] {
      MessageHeader header;
      receive_exactly(reinterpret_cast<char*>(&header), sizeof header);
      run(header);
    });
  }

  template <class Work>
  void fork_for(Socket job, Socket& orders, const Work& work) {
    const pid_t process = fork();
    if (process != 0) {
      at_work_.insert(process);
      return;
    }
    std::signal(SIGCHLD, SIG_DFL);
    orders = Socket();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    channel() = std::move(job);
    answer_no_to_gmsh();
    end_with_channel();
    work();
    _exit(0);  // OpenCASCADE's and gmsh's own tidying up is slow and of no use
  }

  /// Whatever is being computed.
  static void end_with_channel() {
    struct sigaction heard {};
    heard.sa_handler = [](int) {
      char next = 0;
      if (recv(channel().descriptor(), &next, 1, MSG_PEEK | MSG_DONTWAIT) == 0) _exit(0);
    };
    heard.sa_flags = SA_RESTART;
    sigaction(SIGIO, &heard, nullptr);
    const int socket = channel().descriptor();
    fcntl(socket, F_SETOWN, getpid());
    fcntl(socket, F_SETFL, fcntl(socket, F_GETFL) | O_ASYNC);
    raise(SIGIO);  // where it was closed before
  }

  std::set<pid_t> at_work_;
};

}  // namespace
}  // namespace talus

int main() {
  gmsh::initialize();
  talus::Jobs().serve();
  _exit(0);
}
