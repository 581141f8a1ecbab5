#pragma once

#include <vector>

#include "mesh/block.hpp"

/// The flat faces of blocks before anything moved, and where blocks lie against each other.
namespace talus {

/// Triangles of one block's surface that lie in one plane and on one joint. A curved face has as many as its mesh.
struct FlatFace {
  int block = 0;               ///< index into BlockSystem::blocks
  int joint = -1;              ///< index into Project::joints; −1: on no cut
  Vec3 normal = Vec3::Zero();  ///< unit, outwards
  double offset = 0;           ///< m, normal · x of its points
  double area = 0;             ///< m²
  std::vector<int> triangles;  ///< indices into Block::surface
};

/// Part of a face that lies against a face of another block.
struct SharedFace {
  int face = 0, other = 0;  ///< indices into BlockFaces::faces, face < other
  double area = 0;          ///< m²
};

struct BlockFaces {
  std::vector<FlatFace> faces;     ///< block by block
  std::vector<SharedFace> shared;  ///< every pair once
};

/// Two planes are one where their normals part by less than `same_normal` and their offsets by less than
/// `same_plane` of the model's size; a cut leaves both sides on the same plane to rounding.
inline constexpr double same_normal = 1e-4;  ///< rad
inline constexpr double same_plane = 1e-7;

BlockFaces block_faces(const BlockSystem& system);

}  // namespace talus
