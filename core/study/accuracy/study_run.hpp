#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "results/run_report.hpp"
#include "study/accuracy/study_plan.hpp"

namespace talus {

/// How far blocks that may move have gone by the end of a run, and when. Horizontal is across gravity; without gravity
/// ways count whole. Times are since the first dynamic stage began, or the run where none is.
struct StudyTravel {
  double run_out = 0;                ///< m, horizontal: of the centroid that went farthest
  Vec3 mean = Vec3::Zero();          ///< m, that the centre of all their mass has gone
  double extent_growth = 0;          ///< m, of the root mean square distance of the mass, a block a point, from it
  std::optional<double> start, end;  ///< s; empty: no block sets off, or some still move at the end
};

/// Where everything was at one moment of a run.
struct StudyMoment {
  std::string stage;
  double since = 0;                 ///< s, since the stage began
  std::vector<Vec3> displacements;  ///< m: of the centroids of blocks that may move, then of monitors
  std::vector<Voigt> stresses{};    ///< Pa: of the monitors that record it
};

enum class StudyStatus { completed, not_converged, failed };
constexpr std::string_view to_string(StudyStatus status) {
  constexpr std::string_view words[] = {"completed", "not-converged", "failed"};
  return words[static_cast<int>(status)];
}

/// What one run of a study came to.
struct StudyRun {
  StudyStatus status = StudyStatus::completed;
  std::string reason;                         ///< why it is not completed
  double cpu_seconds = 0, wall_seconds = 0;   ///< of solving, with the writing of its results
  double mesh_seconds = 0;                    ///< wall, of cutting and meshing
  long dofs = 0, blocks = 0, tetrahedra = 0;  ///< of what may move: unknowns, blocks and their mesh
  long steps = 0, iterations = 0, cuts = 0;
  std::vector<ExpectationOutcome> expect;
  std::vector<StudyMoment> moments;  ///< quarters of every stage; the end alone where it ends at equilibrium
  StudyTravel travel;
  Phases phases;
  std::vector<EffectOutcome> effects;
};

/// Cuts, meshes and solves run `number` of a study on one thread and writes its file once it has ended, however it
/// ended. What the user could mend in that setting, and that it did not converge, are a status. Throws Cancelled.
void perform_study_run(const StudyFolder& study, int number, Progress& progress);

}  // namespace talus
