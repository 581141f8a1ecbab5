#pragma once

#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "model/project.hpp"

namespace talus {

struct BlockSystem;

/// The run in outline: what may move is rigid and goes through the whole model time in long steps. It costs little and
/// says how much there is to do when: how many contacts there are, and how much sleeps.
class RunOutline {
 public:
  /// `shorter`: by how much its steps are shorter than they could be. Gives up after `budget` [s of the processor].
  /// Throws InputError as Simulation does, Cancelled.
  RunOutline(const Project& project, const BlockSystem& system, double shorter, double budget, Progress& progress);

  /// It reached the end of the run.
  bool came_through() const { return came_through_; }

  struct Load {
    double contacts = 0;    ///< contact points that the effects look at, on the mean
    double awake = 0;       ///< share of the unknowns that may move, 0 to 1, on the mean
    double iterations = 0;  ///< of a step of the outline, on the mean
  };
  /// Between two moments of a stage [s since it began], as far as the outline got; nothing where it did not get there.
  std::optional<Load> load(int stage, double from, double to) const;
  /// Of the last steps that it took, some ten at most; nothing where it took none.
  std::optional<Load> last() const;

  /// m, of the centroids of all blocks at the end.
  const std::vector<Vec3>& displacements() const { return displacements_; }

 private:
  struct Step {
    double end = 0, length = 0;  ///< s, since the stage began
    Load load;
  };
  std::vector<std::vector<Step>> stages_;
  std::vector<Vec3> displacements_;
  bool came_through_ = false;
};

/// Steps of the run in one of the outline's, where that is longest; 1 without a dynamic stage.
double longest_leap(const Project& project);

}  // namespace talus
