#include "study/accuracy/accuracy.hpp"

#include <algorithm>
#include <map>

#include "study/accuracy/choice.hpp"
#include "study/accuracy/measured_error.hpp"
#include "study/accuracy/study_run_json.hpp"

namespace talus {

namespace {

bool completed(const AccuracyRow& row) { return row.run && row.run->status == StudyStatus::completed; }

/// Newmark's method with γ = 1 is of first order in the step, generalized-alpha of second; linear tetrahedra give
/// displacements of second order in the mesh size.
std::optional<double> theory_of(StudyAxis axis, const Setting& own) {
  if (axis == StudyAxis::static_step) return std::nullopt;
  if (axis == StudyAxis::mesh_size) return 2;
  return own.integrator == Integrator::generalized_alpha ? 2 : 1;
}

/// The wanted reference, or else the most expensive run that completed.
int reference_among(const std::vector<AccuracyRow>& rows, int wanted) {
  if (completed(rows[static_cast<std::size_t>(wanted)])) return wanted;
  int best = -1;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!completed(rows[i])) continue;
    const double cost = relative_cost(rows[i].setting);
    if (best < 0 || cost > relative_cost(rows[static_cast<std::size_t>(best)].setting)) best = static_cast<int>(i);
  }
  return best;
}

/// Its time step is not what its setting says.
bool mostly_cut(const StudyRun& run) { return 2 * run.cuts > run.steps; }

/// Runs that differ from the project's own on this axis alone, finest first, and the own one among them.
std::vector<int> runs_along(StudyAxis axis, const std::vector<AccuracyRow>& rows) {
  std::vector<int> runs;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Setting other = rows[i].setting;
    set_own_size(axis, other);
    if (completed(rows[i]) && other == rows.front().setting) runs.push_back(static_cast<int>(i));
  }
  std::sort(runs.begin(), runs.end(), [&](int a, int b) {
    return size_on(axis, rows[static_cast<std::size_t>(a)].setting) <
           size_on(axis, rows[static_cast<std::size_t>(b)].setting);
  });
  return runs;
}

std::optional<AxisOrder> order_along(StudyAxis axis, const AccuracyStudy& study, const ErrorMeasure& measure) {
  AxisOrder order;
  order.axis = axis;
  order.theory = theory_of(axis, study.rows.front().setting);
  const auto row = [&](int run) -> const AccuracyRow& { return study.rows[static_cast<std::size_t>(run)]; };
  for (const int run : runs_along(axis, study.rows))
    (axis != StudyAxis::mesh_size && mostly_cut(*row(run).run) ? order.cut_runs : order.runs).push_back(run);
  if (order.runs.size() < 2) return std::nullopt;
  const AccuracyRow& finest = row(order.runs.front());
  std::vector<AxisDistance> distances;
  for (std::size_t i = 1; i < order.runs.size(); ++i) {
    const AccuracyRow& one = row(order.runs[i]);
    const auto distance = measure.between(*one.run, *finest.run, *row(study.reference).run);
    if (distance) distances.push_back({size_on(axis, one.setting), *distance});
  }
  const auto fit = fit_order(size_on(axis, finest.setting), distances, order.theory);
  if (!fit) return std::nullopt;
  order.fit = *fit;
  return order;
}

void measure_errors(AccuracyStudy& study, const ErrorMeasure& measure) {
  const StudyRun& reference = *study.rows[static_cast<std::size_t>(study.reference)].run;
  for (AccuracyRow& row : study.rows) {
    if (!completed(row)) continue;
    row.from_finest = measure.between(*row.run, reference, reference);
    if (study.known_answer) {
      row.error = measure.from_known(*row.run);
    } else {
      row.error = row.from_finest;
      row.error_estimate = study.reference_error;
    }
    if (study.known_answer && !row.error) row.note = "it ended before the time of an expectation";
  }
  // The finest run's distance from itself says nothing: what is known of its error is the estimate.
  if (!study.known_answer) {
    AccuracyRow& finest = study.rows[static_cast<std::size_t>(study.reference)];
    finest.error = study.reference_error;
    finest.error_estimate = 0;
    finest.note = "the others are held to this run";
  }
}

/// What each run costs and how far off it is, `safe` with its estimate on top.
std::vector<std::optional<CostAndError>> offers_of(const AccuracyStudy& study, bool safe) {
  std::vector<std::optional<CostAndError>> offers;
  for (const AccuracyRow& row : study.rows) {
    std::optional<CostAndError> offer;
    if (row.error) offer = CostAndError{row.run->cpu_seconds, *row.error + (safe ? row.error_estimate : 0)};
    offers.push_back(offer);
  }
  return offers;
}

void mark_the_best(AccuracyStudy& study) {
  const std::vector<bool> front = pareto_front(offers_of(study, false));
  for (std::size_t i = 0; i < study.rows.size(); ++i) study.rows[i].pareto = front[i];
}

std::vector<AccuracyRow> read_rows(const StudyFolder& folder) {
  const std::vector<Setting>& settings = folder.plan().ladder.settings;
  std::vector<AccuracyRow> rows;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    AccuracyRow row;
    row.setting = settings[i];
    row.label = label_of(settings[i], settings.front());
    row.run = read_study_run(folder.run_file(static_cast<int>(i)));
    row.note = row.run ? row.run->reason : "not run";
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

bool AccuracyStudy::complete() const {
  return std::all_of(rows.begin(), rows.end(), [](const AccuracyRow& row) { return row.run.has_value(); });
}

std::string ending_text(const AccuracyRow& row) {
  if (!row.run) return "not run";
  switch (row.run->status) {
    case StudyStatus::not_converged:
      return "not converged";
    case StudyStatus::failed:
      return "failed";
    case StudyStatus::completed:
      break;
  }
  return "–";
}

AccuracyStudy evaluate(const StudyFolder& folder, std::optional<double> target) {
  const Project project = project_of(folder.plan());
  const ErrorMeasure measure(project);
  AccuracyStudy study;
  study.project_file = folder.plan().project_file.string();
  study.project_name = project.name.empty() ? folder.plan().project_file.stem().string() : project.name;
  study.known_answer = measure.known();
  study.target = target;
  study.left_out = folder.plan().ladder.left_out;
  study.rows = read_rows(folder);
  study.reference = reference_among(study.rows, folder.plan().ladder.finest);
  if (study.reference < 0) return study;
  for (const StudyAxis axis : sized_axes)
    if (auto order = order_along(axis, study, measure)) {
      study.reference_error += order->fit.finest_error;
      study.orders.push_back(std::move(*order));
    }
  measure_errors(study, measure);
  mark_the_best(study);
  set_target(study, target);
  return study;
}

void set_target(AccuracyStudy& study, std::optional<double> target) {
  study.target = target;
  study.recommended = target ? cheapest_within(*target, offers_of(study, true)) : -1;
}

}  // namespace talus
