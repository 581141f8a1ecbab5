#pragma once

#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "mesh/block.hpp"
#include "mesh/quality.hpp"

/// How well shaped the tetrahedra of all blocks are: for a histogram, a table of blocks, and a list of the worst. Those
/// of blocks that stand on their corners are not rated.
namespace talus {

/// Counts of values in bins of equal width; what lies on a limit belongs to the bin above, the last one's upper limit
/// to the last.
struct Histogram {
  double low = 0, high = 1;
  std::vector<long> counts;
  double width() const { return (high - low) / static_cast<double>(counts.size()); }
  /// The bin of a value; values beyond the ends belong to the first and the last.
  std::size_t bin_of(double value) const;
};

/// A tetrahedron that is worse shaped than most.
struct PoorTetrahedron {
  int block = 0, tetrahedron = 0;  ///< index into BlockSystem::blocks, and into its mesh
  double quality = 1;              ///< as in MeshQuality
  double smallest_dihedral = 70;   ///< degrees
  Vec3 centre = Vec3::Zero();      ///< m
};

struct MeshSurvey {
  Histogram quality{0, 1, std::vector<long>(20)};    ///< 3 × inscribed / circumscribed radius
  Histogram dihedral{0, 75, std::vector<long>(15)};  ///< smallest angle between two faces, degrees; at most 70.53
  std::vector<std::optional<MeshQuality>> blocks;    ///< in the order of the system; empty: not rated
  std::vector<PoorTetrahedron> worst;                ///< those of least quality, the worst first
};

/// `most_listed`: how many of the worst are told. Throws Cancelled.
MeshSurvey survey_mesh(const BlockSystem& system, Progress& progress, std::size_t most_listed = 50);

}  // namespace talus
