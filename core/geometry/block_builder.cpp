#include "geometry/block_builder.hpp"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/memory_limit.hpp"
#include "geometry/block_description.hpp"
#include "geometry/corner_solids.hpp"
#include "geometry/kept_meshes.hpp"
#include "geometry/mesh_estimate.hpp"
#include "geometry/mesher_answers.hpp"
#include "geometry/mesher_process.hpp"
#include "geometry/mesher_solids.hpp"
#include "geometry/solid_surface.hpp"
#include "model/about_text.hpp"
#include "model/number_text.hpp"
#include "model/rules/validate.hpp"
#include "model/solid_shape.hpp"
#include "orientation/drawn_planes.hpp"
#include "orientation/joint_outline.hpp"

namespace talus {
namespace {

/// The name exists: the project has been validated.
template <class Named>
int index_of(const std::vector<Named>& things, const std::string& name) {
  const auto found = std::find_if(things.begin(), things.end(), [&](const Named& thing) { return thing.name == name; });
  return static_cast<int>(found - things.begin());
}

MesherCut job_cut(const Project& project, std::size_t index) {
  const Cut& cut = project.cuts[index];
  MesherCut job;
  job.title = "cut " + std::to_string(index + 1) + " (" + cut.joint + ")";
  job.joint = index_of(project.joints, cut.joint);
  job.dip = cut.dip;
  job.dip_direction = cut.dip_direction;
  job.through = cut.through;
  job.spacing = cut.spacing.value_or(0);
  job.count = cut.count.value_or(1);
  if (is_drawn(cut) || cut.disc || !cut.polygon.empty())
    for (const Cut& joint : single_planes(cut))
      job.joints.push_back({joint.dip, joint.dip_direction, joint.through, outline_of(joint)});
  for (const std::string& name : cut.solids) job.solids.push_back(index_of(project.solids, name));
  for (const std::string& name : cut.ends_at) job.ends_at.push_back(index_of(project.joints, name));
  job.may_miss = cut.network.has_value();
  return job;
}

MesherJob make_job(const Project& project, const std::filesystem::path& folder) {
  MesherJob job;
  job.solids = mesher_solids(project.solids, project.origin, folder);
  for (MesherSolid& solid : job.solids)
    if (!solid.mesh_size) solid.mesh_size = project.mesh.size;
  for (std::size_t i = 0; i < project.cuts.size(); ++i) job.cuts.push_back(job_cut(project, i));
  const std::vector<bool> of_corners = corner_solids(project);
  for (std::size_t i = 0; i < project.solids.size(); ++i) job.solids[i].corners_suffice = of_corners[i];
  for (const BlockOverride& wanted : project.blocks) {
    job.overrides.push_back({wanted.name, wanted.at, wanted.mesh_size, wanted.removed});
  }
  for (const Merge& merge : project.merges) job.merges.push_back({merge.at, merge.with});
  job.splinter_thickness = project.splinters.thickness;
  job.chip_volume = project.splinters.chip_volume;
  job.splinter_rule = project.splinters.rule;
  for (const MeshRefinement& refinement : project.mesh.refinements) job.refinements.push_back({refinement});
  return job;
}

void take_report(BlockSystem& system, const MesherCutModel& cut) {
  system.solids_volume = cut.solids_volume;
  system.excavated_volume = cut.excavated_volume;
  system.splinters.assign(cut.splinters.begin(), cut.splinters.end());
  system.endings.assign(cut.endings.begin(), cut.endings.end());
}

void take_mesh(Block& block, MesherBlock meshed) {
  block.mesh = {std::move(meshed.nodes), std::move(meshed.tetrahedra)};
  for (std::size_t i = 0; i < meshed.triangles.size(); ++i) {
    block.surface.push_back({meshed.triangles[i], meshed.triangle_joints[i]});
  }
  block.volume = meshed.volume;
}

Project without_what_moves_no_choice(Project project) {
  project.name.clear();
  project.joints.clear();
  project.default_joint.clear();
  project.interfaces.clear();
  project.solver = {};
  project.expect.clear();
  project.output = {};
  return project;
}

/// Throws InputError for blocks whose meshes are more than the project allows, however coarse, or that take more memory
/// than there is.
void require_cuts_that_fit(const Project& project, const MesherCutAhead& ahead) {
  constexpr double least_tetrahedra = 4;  // of a block, one on each of its triangles
  const std::string blocks = "about " + about_text(ahead.blocks) + " blocks", fewer = "take fewer or shorter cuts";
  if (ahead.blocks * least_tetrahedra > project.mesh.most_tetrahedra)
    throw InputError("/cuts",
                     "they would make " + blocks + ", which no mesh of " + number_text(project.mesh.most_tetrahedra) +
                         " tetrahedra holds",
                     fewer + ", or allow more by most_tetrahedra of the mesh");
  require_memory(ahead.bytes, "/cuts", "cutting " + blocks, fewer);
}

/// How finely blocks are meshed, once they are known.
using Sizes = std::function<MesherSizes(const MesherCutModel&, const std::vector<Block>&)>;

/// As the project wants them. Throws InputError for more tetrahedra than it allows.
MesherSizes wanted_sizes(const Project& project, const MesherCutModel& cut, const std::vector<Block>& blocks) {
  const std::vector<BlockToMesh> wanted = blocks_to_mesh(project, cut, blocks);
  for (std::size_t b = 0; b < wanted.size(); ++b)
    if (is_needle(wanted[b]))
      throw InputError("block " + cut.blocks[b].name,
                       "is a needle, " + significant((wanted[b].max - wanted[b].min).norm(), 2) + " m long",
                       "look for a wrong height or corner in its solid, or make mesh_size larger");
  require_a_mesh_that_fits(project, mesh_estimate(wanted, project.mesh.refinements));
  MesherSizes sizes;
  const bool refines = !project.mesh.refinements.empty();
  for (const BlockToMesh& block : wanted) sizes.sizes.push_back({block.size, block.refined && refines});
  return sizes;
}

/// Corners alone.
MesherSizes coarsest_sizes(const MesherCutModel& cut) {
  MesherSizes sizes;
  for (const MesherCutBlock& block : cut.blocks) sizes.sizes.push_back({block.coarsest_size, false});
  return sizes;
}

const char* key_of_file(const SolidShape& shape) {
  return std::holds_alternative<TerrainShape>(shape) ? "/terrain/file" : "/file";
}

/// Throws InputError for a solid that no rock can be made of.
void check_alone(const Solid& solid, const Vec3& origin, const std::filesystem::path& folder, Progress& progress) {
  const SolidSurface surface = solid_surface(solid, origin, folder, progress);
  for (const SurfaceFinding& finding : surface.findings)
    if (is_fatal(finding)) throw unsound(*file_of(solid.shape), finding);
}

/// `kept`: meshes that may be taken over; null: none, and none are kept.
BlockSystem cut_and_mesh(const Project& project, const std::filesystem::path& folder, const Sizes& sizes,
                         Progress& progress, KeptMeshes* kept = nullptr) {
  validate_for_cutting(project);
  const MesherJob job = make_job(project, folder);
  if (progress.cancelled()) throw Cancelled{};
  BlockSystem system;
  for (const Joint& joint : project.joints) system.joint_names.push_back(joint.name);
  for (const Material& material : project.materials) system.strengths.push_back(material.strength);
  MesherProcess mesher(MessageKind::job, to_bytes(job));
  MesherAnswers answers(mesher, progress, "try a larger mesh_size, or move the cuts there");
  std::size_t meshed = 0;  // blocks
  for (;;) {
    const auto message = answers.next();
    if (message.kind == MessageKind::ahead) {
      require_cuts_that_fit(project, from_bytes<MesherCutAhead>(message.bytes));
    } else if (message.kind == MessageKind::cut) {
      const auto cut = from_bytes<MesherCutModel>(message.bytes);
      take_report(system, cut);
      system.blocks = described_blocks(project, cut);
      MesherSizes wanted = sizes(cut, system.blocks);
      if (kept) wanted.known = kept->keys();
      mesher.send(MessageKind::sizes, to_bytes(wanted));
    } else if (message.kind == MessageKind::block) {
      auto block = from_bytes<MesherBlock>(message.bytes);
      take_mesh(system.blocks.at(meshed++), kept ? kept->mesh_of(std::move(block)) : std::move(block));
    } else if (message.kind == MessageKind::end) {
      if (kept) kept->end_of_build();
      progress.report(1, "meshed");
      return system;
    } else {
      throw std::runtime_error("the mesher answered with what was not asked for");
    }
  }
}

}  // namespace

std::vector<InputError> broken_files(const Project& project, const std::filesystem::path& folder, Progress& progress) {
  std::vector<InputError> broken;
  for (std::size_t i = 0; i < project.solids.size(); ++i) {
    const Solid& solid = project.solids[i];
    if (!file_of(solid.shape)) continue;
    try {
      check_alone(solid, project.origin, folder, progress);
    } catch (const InputError& error) {
      const bool is_of_solid = error.place() == "solid " + solid.name;  // as is the place here
      broken.emplace_back("/solids/" + std::to_string(i) + key_of_file(solid.shape),
                          is_of_solid ? error.problem() : error.place() + ": " + error.problem(), error.remedy());
    }
  }
  return broken;
}

BlockSystem build_blocks(const Project& project, const std::filesystem::path& folder, Progress& progress) {
  return cut_and_mesh(
      project, folder,
      [&](const MesherCutModel& cut, const std::vector<Block>& blocks) { return wanted_sizes(project, cut, blocks); },
      progress);
}

BlockSystem build_blocks(const Project& project, const std::filesystem::path& folder, Progress& progress,
                         KeptMeshes& kept) {
  return cut_and_mesh(
      project, folder,
      [&](const MesherCutModel& cut, const std::vector<Block>& blocks) { return wanted_sizes(project, cut, blocks); },
      progress, &kept);
}

BlockSystem cut_blocks(const Project& project, const std::filesystem::path& folder, Progress& progress) {
  return cut_and_mesh(
      project, folder, [](const MesherCutModel& cut, const std::vector<Block>&) { return coarsest_sizes(cut); },
      progress);
}

bool build_alike(const Project& a, const Project& b) {
  const auto rock = [](const Project& project) {
    return std::tie(project.origin, project.solids, project.cuts, project.blocks, project.merges, project.splinters,
                    project.mesh);
  };
  if (rock(a) != rock(b)) return false;
  const auto left_open = [](const auto& thing) { return thing.body == BodyKind::automatic; };
  const bool chosen = std::any_of(a.solids.begin(), a.solids.end(), left_open) ||
                      std::any_of(a.blocks.begin(), a.blocks.end(), left_open);
  return !chosen || without_what_moves_no_choice(a) == without_what_moves_no_choice(b);
}

}  // namespace talus
