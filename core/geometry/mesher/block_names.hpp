#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/mesher/block_cutter.hpp"

namespace talus {

/// A block as the project calls it.
struct NamedBlock {
  std::string name;
  int block_override = -1;  ///< index into MesherJob::overrides; −1: none
  double mesh_size = 0;     ///< m
};

/// One for each block of `cut`, in its order: the solid's name when it came in one piece, else NAME.1, NAME.2, … in
/// the order of `cut`; an override that names a block replaces that alone, the others keep their numbers.
/// Throws InputError for an override whose point lies in no block or on the border of two, for two overrides in one
/// block and for names given twice.
std::vector<NamedBlock> name_blocks(const MesherJob& job, const ImportedModel& model, const CutModel& cut);

}  // namespace talus
