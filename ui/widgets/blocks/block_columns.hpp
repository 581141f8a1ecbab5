#pragma once

#include <memory>
#include <vector>

#include "mesh/mesh_survey.hpp"
#include "model/project.hpp"
#include "removability/block_facts.hpp"
#include "widgets/blocks/block_rows.hpp"

/// What the tables of the pages Blocks and Mesh tell of each block.
namespace talus {

/// Name, body, volume, faces, neighbours, joints, and how a block leaves its place. `built`: the project that the
/// blocks were cut from; facts may be null: they are not known yet.
std::vector<BlockColumn> blockColumns(std::shared_ptr<const BlockSystem> system, const Project& built,
                                      std::shared_ptr<const std::vector<BlockFacts>> facts);

/// Name, nodes, tetrahedra, and how well shaped they are. The survey may be null.
std::vector<BlockColumn> meshColumns(std::shared_ptr<const BlockSystem> system,
                                     std::shared_ptr<const MeshSurvey> survey);

}  // namespace talus
