#pragma once

#include <string>
#include <vector>

#include "geometry/mesher/blocks/block_cutter.hpp"

namespace talus {

/// The blocks that the project makes of the pieces, and what it leaves out.
struct KeptBlocks {
  std::vector<NamedBlock> blocks;         ///< in the order of the pieces
  std::vector<MesherSplinter> splinters;  ///< dropped or merged; where they are, as the project has coordinates
  double excavated_volume = 0;            ///< m³
};

/// Pieces are called as their solid where it came in one piece, else NAME.1, NAME.2, … in the order of `cut`; whatever
/// is made of other pieces, each keeps its number. Then, in this order,
/// - merges make blocks one, which have the name and the properties of the first;
/// - overrides name a block and say what it is: in a merged block that of the first piece counts, or else the only one;
/// - removed blocks are left out;
/// - splinters are treated as the project says, the thinnest first.
/// Throws InputError for a point in no block or on the border of two, for merges of blocks that share no face, for two
/// overrides in one block and for names given twice; SplintersFound where splinters are refused.
KeptBlocks keep_blocks(const MesherJob& job, const ImportedModel& model, const CutModel& cut);

}  // namespace talus
