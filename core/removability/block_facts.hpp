#pragma once

#include <string>
#include <vector>

#include "mesh/block_faces.hpp"
#include "removability/removability.hpp"

namespace talus {

/// What a table of blocks tells of one, where it was cut.
struct BlockFacts {
  int faces = 0;                       ///< flat ones
  int free_faces = 0;                  ///< those against no other block
  Vec3 centroid = Vec3::Zero();        ///< m
  double area = 0;                     ///< m²
  double free_area = 0;                ///< m², against no other block
  std::vector<int> neighbours;         ///< blocks that it lies against, ascending
  std::vector<int> joints;             ///< of its faces, indices into Project::joints, ascending
  double slenderness = 0;              ///< see `slenderness` below
  bool fixed = false;                  ///< its body is fixed: it never leaves
  Removability leaving;                ///< by the weight of its rock and the joints that it lies on
  std::vector<std::string> slides_on;  ///< joints of the planes it slides on, in the order of `leaving.on`
};

/// The longest side of the box around a block over 3 V / A: 2 of a cube, 2 n / 3 of a plate of 1 : n, 4 n / 3 of a
/// needle.
double slenderness(const Block& block, double area);

/// A block that is more slender is called a sliver: a plate of 1 : 30, a needle of 1 : 15. Mesh and contact have
/// trouble with it, and few joints are known well enough to believe in it.
inline constexpr double sliver_slenderness = 20;

/// Block by block, in the order of the system. The joint of two faces that touch is that of the cut which made them,
/// else of the interface between the blocks, else the project's default.
std::vector<BlockFacts> block_facts(const Project& project, const BlockSystem& system);

}  // namespace talus
