#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesh/cutting_report.hpp"
#include "mesh/tet_mesh.hpp"
#include "model/project.hpp"

namespace talus {

/// A block of rock, cut and meshed. Blocks have no nodes in common.
struct Block {
  std::string name;
  int solid = 0;     ///< index into Project::solids
  int material = 0;  ///< index into Project::materials
  BodyKind body = BodyKind::tetrahedra;
  std::string body_reason{};  ///< why it was chosen, in words; empty where the project says the body
  TetMesh mesh;
  std::vector<SurfaceTriangle> surface;
  double volume = 0;  ///< m³, of the shape before meshing
  /// It moves as a whole, and is meshed from its corners alone: what shape its tetrahedra have matters to nothing.
  bool stands_on_corners = false;
};

/// All blocks of a project. Node numbers of a frame run through the blocks in this order.
struct BlockSystem {
  std::vector<Block> blocks;
  std::vector<std::string> joint_names;                  ///< as Project::joints, for SurfaceTriangle::joint
  std::vector<std::optional<RockStrength>> strengths{};  ///< as Project::materials; none: not known of any
  double solids_volume = 0;                              ///< m³, of the solids before cutting
  double excavated_volume = 0;          ///< m³, of blocks that are cut and then left out, as the project wants
  std::vector<Splinter> splinters{};    ///< what was too thin to be a block, and is left out or part of another
  std::vector<EndingJoints> endings{};  ///< of each cut whose joints end, what they divide
};

}  // namespace talus
