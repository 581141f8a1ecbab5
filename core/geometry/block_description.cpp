#include "geometry/block_description.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/block_names.hpp"
#include "model/body_choice.hpp"
#include "model/rules/validate.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {
namespace {

const BlockOverride* override_of(const Project& project, const MesherCutBlock& cut) {
  return cut.block_override < 0 ? nullptr : &project.blocks[static_cast<std::size_t>(cut.block_override)];
}

int material_named(const Project& project, const std::string& name) {
  const auto found = std::ranges::find(project.materials, name, &Material::name);
  return static_cast<int>(found - project.materials.begin());  // it exists: the project has been validated
}

bool corners_suffice_for(const Project& project, const MesherCutBlock& cut, BodyKind body) {
  return corners_suffice(body, project.solids[static_cast<std::size_t>(cut.solid)], override_of(project, cut),
                         cut.of_cells);
}

/// False where its faces are curved: it is meshed to the usual size then.
bool stands_on_corners(const Project& project, const MesherCutBlock& cut, BodyKind body) {
  return cut.coarsest_size != cut.usual_size && corners_suffice_for(project, cut, body);
}

Block described_block(const Project& project, const MesherCutBlock& cut, const BodyChooser& chooser) {
  const Solid& solid = project.solids[static_cast<std::size_t>(cut.solid)];
  Block block;
  block.name = cut.name;
  block.solid = cut.solid;
  block.body = solid.body;
  block.volume = cut.volume;
  std::string material = solid.material;
  if (const BlockOverride* wanted = override_of(project, cut)) {
    block.body = wanted->body.value_or(block.body);
    material = wanted->material.value_or(material);
  }
  block.material = material_named(project, material);
  if (block.body == BodyKind::automatic) {
    BodyChoice choice = chooser.choose(block.name, project.materials[static_cast<std::size_t>(block.material)]);
    block.body = choice.body;
    block.body_reason = std::move(choice.reason);
  }
  block.stands_on_corners = stands_on_corners(project, cut, block.body);
  return block;
}

void check_built_blocks(const Project& project, const std::vector<Block>& blocks) {
  std::vector<BuiltBlock> built;
  for (const Block& block : blocks) built.push_back({block.name, block.body, !block.body_reason.empty()});
  validate_against_blocks(project, built);
}

/// Monitors far from their blocks are found before these are meshed.
void check_monitors(const Project& project, const MesherCutModel& cut) {
  const double allowed = EffectTolerances{}.point_outside_block * std::cbrt(cut.solids_volume);
  for (const Monitor& monitor : project.monitors) {
    const auto block = std::ranges::find(cut.blocks, monitor.block, &MesherCutBlock::name);
    const Eigen::AlignedBox3d box(block->min, block->max);  // it is there: what names blocks has been checked
    if (box.exteriorDistance(monitor.at) > allowed)
      throw point_outside_block("monitor '" + monitor.name + "'", monitor.block);
  }
}

}  // namespace

std::vector<Block> described_blocks(const Project& project, const MesherCutModel& cut) {
  const BodyChooser chooser(project, cut.extent);
  std::vector<Block> blocks;
  for (const MesherCutBlock& block : cut.blocks) blocks.push_back(described_block(project, block, chooser));
  check_built_blocks(project, blocks);
  check_monitors(project, cut);
  return blocks;
}

bool corners_suffice(BodyKind body, const Solid& solid, const BlockOverride* wanted, bool of_cells) {
  const bool given = solid.mesh_size || (wanted && wanted->mesh_size);
  return !given && (body == BodyKind::rigid || body == BodyKind::affine || (body == BodyKind::fixed && of_cells));
}

std::vector<BlockToMesh> blocks_to_mesh(const Project& project, const MesherCutModel& cut,
                                        const std::vector<Block>& blocks) {
  std::vector<BlockToMesh> wanted;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const MesherCutBlock& shape = cut.blocks[b];
    const bool coarse = corners_suffice_for(project, shape, blocks[b].body);
    wanted.push_back({blocks[b].body, coarse ? shape.coarsest_size : shape.usual_size, !coarse, shape.volume,
                      shape.area, shape.min, shape.max, shape.of_cells, static_cast<double>(shape.corners)});
  }
  return wanted;
}

}  // namespace talus
