#include "run/run_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/error.hpp"
#include "base/memory_limit.hpp"
#include "mesh/unknowns.hpp"
#include "model/about_text.hpp"
#include "model/stage_length.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// Of meshed blocks of 1 200 to 33 000 nodes: elements, pattern and contacts grow with the nodes; the factor of the
/// matrix, ordered by nested dissection, with their power 4/3 (George 1973).
double memory_of(const Block& block) {
  constexpr double of_node = 8e3, of_factor = 940, of_body = 20e3;
  const auto nodes = static_cast<double>(block.mesh.nodes.size());
  switch (block.body) {
    case BodyKind::fixed:
      return 0;
    case BodyKind::rigid:
    case BodyKind::affine:
      return of_body;
    case BodyKind::tetrahedra:
    case BodyKind::automatic:
      break;
  }
  return of_node * nodes + of_factor * std::pow(nodes, 4.0 / 3);
}

/// A stage that may end at equilibrium has no more than its last frame for certain.
double frames_of(const Stage& stage, double every) {
  if (stage.until_equilibrium) return 1;
  return std::max(1.0, std::floor(length_of(stage) / std::max(every, stage.time_step) + 1e-9));
}

double steps_of(const Stage& stage) { return stage.until_equilibrium ? 1 : length_of(stage) / stage.time_step; }

/// The folder itself, or the first one above it that is there.
fs::path existing(fs::path folder) {
  std::error_code ignored;
  for (folder = fs::absolute(folder, ignored); !fs::exists(folder, ignored) && folder.has_relative_path();)
    folder = folder.parent_path();
  return folder;
}

double bytes_in(const fs::path& folder) {
  std::error_code error;
  double bytes = 0;
  for (const char* name : {"results.h5", "frames.h5", "steps.csv", "history.csv", "checkpoint.h5"}) {
    const auto size = fs::file_size(folder / name, error);
    if (!error) bytes += static_cast<double>(size);
  }
  return bytes;
}

}  // namespace

RunEstimate run_estimate(const Project& project, const BlockSystem& system) {
  constexpr double of_node = 9 * sizeof(double), of_tetrahedron = 6 * sizeof(float), of_frame = 200, of_step = 250;
  RunEstimate estimate;
  double frame = of_frame;
  for (const Block& block : system.blocks) {
    estimate.memory += memory_of(block);
    frame += of_node * static_cast<double>(block.mesh.nodes.size()) +
             of_tetrahedron * static_cast<double>(block.mesh.tetrahedra.size());
  }
  estimate.frames = 1;
  for (const Stage& stage : project.stages) {
    estimate.frames += frames_of(stage, project.output.every);
    estimate.results += of_step * steps_of(stage);
  }
  estimate.results += frame * estimate.frames;
  return estimate;
}

void require_room(const RunEstimate& estimate, const fs::path& folder) {
  require_memory(estimate.memory, "/solids", "solving", "make mesh sizes larger, blocks rigid or affine");
  std::error_code error;
  const fs::space_info disk = fs::space(existing(folder), error);
  const double free = static_cast<double>(disk.available) + bytes_in(folder);
  if (error || estimate.results <= free) return;
  throw InputError("/output/every",
                   "the results would take " + bytes_text(estimate.results) + " in " + about_text(estimate.frames) +
                       " frames, and the disk has " + bytes_text(free) + " free",
                   "let frames be rarer or the run shorter, or choose another folder with --out");
}

}  // namespace talus
