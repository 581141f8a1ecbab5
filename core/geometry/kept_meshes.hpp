#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "geometry/mesher_job.hpp"

namespace talus {

/// Meshes of blocks that were built before, so that a build fills only those anew of which surface, size or refinements
/// are others. A block is known by all that its mesh is made of, which is the same bits each time: what is taken over
/// is what meshing would make.
class KeptMeshes {
 public:
  /// Of all that are kept.
  std::vector<std::uint64_t> keys() const;
  /// The mesh of a block that a mesher answered with: its own, which is kept, or the one that it says is known.
  const MesherBlock& mesh_of(MesherBlock answer);
  /// All blocks are built: what none of them used goes. One that is cancelled keeps what it had and what it made.
  void end_of_build();
  /// How many blocks of the last whole build were taken over.
  int taken_over() const { return taken_over_; }

 private:
  std::map<std::uint64_t, MesherBlock> meshes_;
  MesherBlock passing_;  ///< of corners alone: not kept
  std::set<std::uint64_t> used_;
  int taken_ = 0, taken_over_ = 0;
};

}  // namespace talus
