#include "session/splinter_list.hpp"

#include <cmath>
#include <limits>

#include "jobs/solver_job.hpp"
#include "orientation/attitude.hpp"
#include "orientation/drawn_planes.hpp"
#include "session/current_project.hpp"
#include "session/current_run.hpp"

namespace talus {

SplinterList::SplinterList(CurrentProject& project, CurrentRun& run) : project_(project) {
  connect(&run.job(), &SolverJob::ended, this, &SplinterList::takeEnd);
  connect(&project_, &CurrentProject::systemChanged, this, &SplinterList::takeSystem);
  connect(&project_, &CurrentProject::opened, this, &SplinterList::takeSystem);
}

void SplinterList::takeEnd(const JobEnd& end) {
  if (end.splinters.empty()) return;
  all_ = end.splinters;
  emit changed();
}

void SplinterList::takeSystem() {
  const bool hadSome = !all_.empty();
  all_.clear();
  if (project_.system()) all_ = project_.system()->splinters;
  if (hadSome || !all_.empty()) emit changed();
}

void SplinterList::decide(SplinterRule rule) {
  Project changed = project_.document().project();
  changed.splinters.rule = rule;
  project_.document().change(changed, rule == SplinterRule::drop    ? tr("leave splinters out")
                                      : rule == SplinterRule::merge ? tr("merge splinters with their neighbours")
                                                                    : tr("refuse splinters"));
}

std::optional<int> SplinterList::cutBeside(const Splinter& splinter) const {
  const auto& cuts = project_.document().project().cuts;
  std::optional<int> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (const Cut& plane : single_planes(cuts[i])) {
      const double away = std::abs(pole_of({plane.dip, plane.dip_direction}).dot(splinter.where - plane.through));
      if (away >= least) continue;
      least = away;
      nearest = static_cast<int>(i);
    }
  return nearest;
}

}  // namespace talus
