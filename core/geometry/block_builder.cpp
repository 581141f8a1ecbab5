#include "geometry/block_builder.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "geometry/mesher_answers.hpp"
#include "geometry/mesher_process.hpp"
#include "geometry/mesher_solids.hpp"
#include "geometry/solid_surface.hpp"
#include "model/body_choice.hpp"
#include "model/rules/validate.hpp"
#include "model/solid_shape.hpp"
#include "orientation/drawn_planes.hpp"

namespace talus {
namespace {

/// The name exists: the project has been validated.
template <class Named>
int index_of(const std::vector<Named>& things, const std::string& name) {
  const auto found = std::find_if(things.begin(), things.end(), [&](const Named& thing) { return thing.name == name; });
  return static_cast<int>(found - things.begin());
}

/// What the format knows and geometry does not make yet.
void refuse_unmade(const Project& project) {
  for (const Cut& cut : project.cuts) {
    if (cut.disc || !cut.polygon.empty() || cut.network || !cut.ends_at.empty())
      throw InputError("cut of " + cut.joint, "this version cuts along endless planes alone",
                       "give it a point 'through', limited to some 'solids' where it must not cut all");
  }
  const auto removed = [](const BlockOverride& block) { return block.removed; };
  if (!project.merges.empty() || project.splinters != Splinters() || project.mesh != MeshSettings() ||
      std::any_of(project.blocks.begin(), project.blocks.end(), removed))
    throw InputError("/", "this version does not merge, drop or refine blocks", "leave merges, splinters and mesh out");
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
  if (is_drawn(cut))
    for (const Cut& plane : single_planes(cut)) job.drawn.push_back({plane.dip, plane.dip_direction, plane.through});
  for (const std::string& name : cut.solids) job.solids.push_back(index_of(project.solids, name));
  return job;
}

MesherJob make_job(const Project& project, const std::filesystem::path& folder) {
  refuse_unmade(project);
  MesherJob job;
  job.solids = mesher_solids(project.solids, project.origin, folder);
  for (std::size_t i = 0; i < project.cuts.size(); ++i) job.cuts.push_back(job_cut(project, i));
  for (const BlockOverride& wanted : project.blocks) {
    job.overrides.push_back({wanted.name, wanted.at, wanted.mesh_size});
  }
  return job;
}

/// What the project and, where it leaves the body open, the chooser say of a block that is cut and named.
Block described_block(const Project& project, const MesherCutBlock& cut, const BodyChooser& chooser) {
  const Solid& solid = project.solids[static_cast<std::size_t>(cut.solid)];
  Block block;
  block.name = cut.name;
  block.solid = cut.solid;
  block.body = solid.body;
  std::string material = solid.material;
  if (cut.block_override >= 0) {
    const BlockOverride& wanted = project.blocks[static_cast<std::size_t>(cut.block_override)];
    block.body = wanted.body.value_or(block.body);
    material = wanted.material.value_or(material);
  }
  block.material = index_of(project.materials, material);
  if (block.body == BodyKind::automatic) {
    BodyChoice choice = chooser.choose(block.name, project.materials[static_cast<std::size_t>(block.material)]);
    block.body = choice.body;
    block.body_reason = std::move(choice.reason);
  }
  return block;
}

bool has_given_size(const Project& project, const MesherCutBlock& cut) {
  return project.solids[static_cast<std::size_t>(cut.solid)].mesh_size.has_value() ||
         (cut.block_override >= 0 &&
          project.blocks[static_cast<std::size_t>(cut.block_override)].mesh_size.has_value());
}

/// Rigid and affine blocks need tetrahedra for their volume alone.
double mesh_size_of(const Project& project, const MesherCutBlock& cut, BodyKind body) {
  const bool moves_by_few_freedoms = body == BodyKind::rigid || body == BodyKind::affine;
  return moves_by_few_freedoms && !has_given_size(project, cut) ? cut.coarsest_size : cut.usual_size;
}

void check_built_blocks(const Project& project, const std::vector<Block>& blocks) {
  std::vector<BuiltBlock> built;
  for (const Block& block : blocks) built.push_back({block.name, block.body, !block.body_reason.empty()});
  validate_against_blocks(project, built);
}

/// Blocks without their meshes, and how finely each is to be meshed.
MesherSizes describe_blocks(const Project& project, const MesherCutModel& cut, std::vector<Block>& blocks) {
  const BodyChooser chooser(project, cut.extent);
  MesherSizes sizes;
  for (const MesherCutBlock& block : cut.blocks) {
    blocks.push_back(described_block(project, block, chooser));
    sizes.sizes.push_back(mesh_size_of(project, block, blocks.back().body));
  }
  check_built_blocks(project, blocks);
  return sizes;
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

const char* key_of_file(const SolidShape& shape) {
  return std::holds_alternative<TerrainShape>(shape) ? "/terrain/file" : "/file";
}

/// Throws InputError for a solid that no rock can be made of.
void check_alone(const Solid& solid, const Vec3& origin, const std::filesystem::path& folder, Progress& progress) {
  const SolidSurface surface = solid_surface(solid, origin, folder, progress);
  for (const SurfaceFinding& finding : surface.findings)
    if (is_fatal(finding)) throw unsound(*file_of(solid.shape), finding);
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
      broken.emplace_back("/solids/" + std::to_string(i) + key_of_file(solid.shape),
                          error.place() + ": " + error.problem(), error.remedy());
    }
  }
  return broken;
}

BlockSystem build_blocks(const Project& project, const std::filesystem::path& folder, Progress& progress) {
  validate_for_cutting(project);
  const MesherJob job = make_job(project, folder);
  if (progress.cancelled()) throw Cancelled{};
  BlockSystem system;
  for (const Joint& joint : project.joints) system.joint_names.push_back(joint.name);
  MesherProcess mesher;
  mesher.send(MessageKind::job, to_bytes(job));
  MesherAnswers answers(mesher, progress, "try a larger mesh_size, or move the cuts there");
  std::size_t meshed = 0;  // blocks
  for (;;) {
    const auto message = answers.next();
    if (message.kind == MessageKind::cut) {
      const auto cut = from_bytes<MesherCutModel>(message.bytes);
      mesher.send(MessageKind::sizes, to_bytes(describe_blocks(project, cut, system.blocks)));
    } else if (message.kind == MessageKind::block) {
      take_mesh(system.blocks.at(meshed++), from_bytes<MesherBlock>(message.bytes));
    } else if (message.kind == MessageKind::end) {
      system.solids_volume = from_bytes<MesherEnd>(message.bytes).solids_volume;
      progress.report(1, "meshed");
      return system;
    } else {
      throw std::runtime_error("the mesher answered with what was not asked for");
    }
  }
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
