#include "study/accuracy/accuracy.hpp"

#include <algorithm>
#include <cmath>

#include "study/accuracy/choice.hpp"
#include "study/accuracy/mean_run.hpp"
#include "study/accuracy/measured_error.hpp"
#include "study/accuracy/study_run_json.hpp"

namespace talus {

namespace {

bool completed(const AccuracyRow& row) { return row.run && row.run->status == StudyStatus::completed; }

/// A setting's answers, and none of those that have none.
using Answers = std::vector<std::optional<StudyAnswer>>;

/// Newmark's method with γ = 1 is of first order in the step, generalized-alpha of second; linear tetrahedra give
/// displacements of second order in the mesh size. Springs of contacts give way by force over stiffness.
std::optional<double> theory_of(StudyAxis axis, const Setting& own) {
  if (axis == StudyAxis::static_step) return std::nullopt;
  if (axis == StudyAxis::mesh_size) return 2;
  if (axis == StudyAxis::contact_stiffness) return 1;
  return own.integrator == Integrator::generalized_alpha ? 2 : 1;
}

/// The wanted reference, or else the most expensive setting, of those that answer.
int reference_among(const std::vector<AccuracyRow>& rows, const Answers& answers, int wanted) {
  if (answers[static_cast<std::size_t>(wanted)]) return wanted;
  int best = -1;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!answers[i]) continue;
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

/// Means that lie farther apart than so many of their standard errors do not do so by chance.
constexpr double beyond_chance = 3;

/// How far apart means of settings may come by chance, relative.
double apart_by_chance(const AccuracyStudy& study) {
  return beyond_chance * std::sqrt(2.0 / study.repeats) * study.scatter.value_or(0);
}

std::optional<AxisOrder> order_along(StudyAxis axis, const AccuracyStudy& study, const ErrorMeasure& measure,
                                     const Answers& answers) {
  AxisOrder order;
  order.axis = axis;
  order.theory = theory_of(axis, study.rows.front().setting);
  const auto row = [&](int run) -> const AccuracyRow& { return study.rows[static_cast<std::size_t>(run)]; };
  for (const int run : runs_along(axis, study.rows))
    (axis != StudyAxis::mesh_size && mostly_cut(*row(run).run) ? order.cut_runs : order.runs).push_back(run);
  if (order.runs.size() < 2) return std::nullopt;
  const auto answer = [&](int run) -> const auto& { return answers[static_cast<std::size_t>(run)]; };
  const int finest = order.runs.front();
  std::vector<AxisDistance> distances;
  for (const int one : order.runs) {
    if (one == finest || !answer(one) || !answer(finest)) continue;
    const auto distance = measure.between(*answer(one), *answer(finest), *answer(study.reference));
    if (distance) distances.push_back({size_on(axis, row(one).setting), *distance});
  }
  const auto fit = fit_order(size_on(axis, row(finest).setting), distances, order.theory, apart_by_chance(study));
  if (!fit) return std::nullopt;
  order.fit = *fit;
  return order;
}

/// How far repeats scatter: of each setting, and of all together.
void measure_spread(AccuracyStudy& study, const ErrorMeasure& measure, const Answers& answers) {
  if (study.repeats == 1) return;
  double squares = 0;
  int count = 0;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    if (!answers[i]) continue;
    AccuracyRow& row = study.rows[i];
    row.spread = measure.spread(*answers[i], *answers[static_cast<std::size_t>(study.reference)]);
    row.standard_error = *row.spread / std::sqrt(study.repeats);
    squares += *row.spread * *row.spread;
    ++count;
  }
  study.scatter = std::sqrt(squares / count);
}

void measure_errors(AccuracyStudy& study, const ErrorMeasure& measure, const Answers& answers) {
  AccuracyRow& finest = study.rows[static_cast<std::size_t>(study.reference)];
  const StudyAnswer& reference = *answers[static_cast<std::size_t>(study.reference)];
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    AccuracyRow& row = study.rows[i];
    if (answers[i]) row.from_finest = measure.between(*answers[i], reference, reference);
    if (study.known_answer) {
      if (answers[i]) row.error = measure.from_known(*answers[i]);
      row.error_estimate = row.standard_error;
    } else {
      row.error = row.from_finest;
      row.error_estimate = study.reference_error + std::hypot(row.standard_error, finest.standard_error);
    }
  }
  // The finest run's distance from itself says nothing: what is known of its error is the estimate.
  if (study.known_answer) return;
  finest.error = study.reference_error;
  finest.error_estimate = finest.standard_error;
  finest.note = "the others are held to this run";
}

/// Whether any setting's mean lies farther from the finest's than chance takes it.
void tell_apart(AccuracyStudy& study) {
  if (!study.scatter) return;
  study.told_apart = std::any_of(study.rows.begin(), study.rows.end(), [&](const AccuracyRow& row) {
    return row.from_finest.value_or(0) > std::max(rounding, apart_by_chance(study));
  });
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

/// The repeats of a setting that have ended.
std::vector<StudyRun> read_repeats(const StudyFolder& folder, int setting) {
  std::vector<StudyRun> runs;
  for (int repeat = 0; repeat < folder.plan().repeats; ++repeat)
    if (auto run = read_study_run(folder.run_file(folder.plan().run_of(setting, repeat))))
      runs.push_back(std::move(*run));
  return runs;
}

std::string note_of(const std::vector<StudyRun>& ended, int repeats) {
  if (ended.empty()) return "not run";
  return std::to_string(ended.size()) + " of " + std::to_string(repeats) + " repeats have ended";
}

/// Why a run that completed has no answer.
std::string no_answer_text(const AccuracyStudy& study) {
  if (study.known_answer) return "it ended before the time of an expectation";
  if (study.measure == StudyMeasure::start) return "no block sets off";
  if (study.measure == StudyMeasure::end) return "no block moves, or some still do at the end";
  return "it has nothing that is measured";
}

/// A row a setting, and what each answers once all of its repeats have ended.
Answers read_rows(const StudyFolder& folder, const ErrorMeasure& measure, AccuracyStudy& study) {
  const std::vector<Setting>& settings = folder.plan().ladder.settings;
  Answers answers;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    AccuracyRow& row = study.rows.emplace_back();
    row.setting = settings[i];
    row.label = label_of(settings[i], settings.front());
    const std::vector<StudyRun> repeats = read_repeats(folder, static_cast<int>(i));
    const bool all = static_cast<int>(repeats.size()) == study.repeats;
    if (all) row.run = mean_run(repeats);
    answers.push_back(all ? measure.mean_answer(repeats) : std::nullopt);
    row.note = all ? row.run->reason : note_of(repeats, study.repeats);
    if (completed(row) && !answers.back()) row.note = no_answer_text(study);
  }
  return answers;
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
  const ErrorMeasure measure(project, folder.plan().measure);
  AccuracyStudy study;
  study.project_file = folder.plan().project_file.string();
  study.project_name = project.name.empty() ? folder.plan().project_file.stem().string() : project.name;
  study.known_answer = measure.known();
  study.measure = folder.plan().measure.value_or(StudyMeasure::displacement);
  study.target = target;
  study.left_out = folder.plan().ladder.left_out;
  study.repeats = folder.plan().repeats;
  const Answers answers = read_rows(folder, measure, study);
  study.reference = reference_among(study.rows, answers, folder.plan().ladder.finest);
  if (study.reference < 0) return study;
  measure_spread(study, measure, answers);
  for (const StudyAxis axis : sized_axes)
    if (auto order = order_along(axis, study, measure, answers)) {
      study.reference_error += order->fit.finest_error;
      study.orders.push_back(std::move(*order));
    }
  measure_errors(study, measure, answers);
  tell_apart(study);
  mark_the_best(study);
  set_target(study, target);
  return study;
}

void set_target(AccuracyStudy& study, std::optional<double> target) {
  study.target = target;
  study.recommended = target ? cheapest_within(*target, offers_of(study, true)) : -1;
}

}  // namespace talus
