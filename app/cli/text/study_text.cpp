#include "text/study_text.hpp"

#include <algorithm>
#include <numeric>

#include "render/charts/log_axis.hpp"
#include "render/paint/numbers.hpp"
#include "text/paragraph.hpp"
#include "text/table.hpp"

namespace talus::cli {

namespace {

std::string error_of(const AccuracyRow& row) {
  if (!row.error) return ending_text(row);
  return error_text(*row.error) + (row.error_estimate > 0 ? " ± " + error_text(row.error_estimate) : "");
}

std::string spread_of(const AccuracyRow& row) { return row.spread ? error_text(*row.spread) : "–"; }

/// Those that did not run go last.
std::vector<std::size_t> by_cost(const AccuracyStudy& study) {
  std::vector<std::size_t> order(study.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto seconds = [&](std::size_t i) {
    return study.rows[i].error ? study.rows[i].run->cpu_seconds : std::numeric_limits<double>::infinity();
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return seconds(a) < seconds(b); });
  return order;
}

std::string runs_text(const std::vector<int>& runs) {
  std::string text = runs.size() > 1 ? "Runs " : "Run ";
  for (std::size_t i = 0; i < runs.size(); ++i)
    text += (i == 0 ? "" : i + 1 < runs.size() ? ", " : " and ") + std::to_string(runs[i]);
  return text;
}

std::string name_of(StudyAxis axis) {
  if (axis == StudyAxis::mesh_size) return "mesh size";
  if (axis == StudyAxis::contact_stiffness) return "softness of contacts";
  return axis == StudyAxis::time_step ? "time step" : "step of static stages";
}

std::string convergence_text(const AxisOrder& order, const std::string& name) {
  switch (order.fit.convergence) {
    case Convergence::exact:
      return "The " + name + " does not matter: all runs agree to rounding.";
    case Convergence::not_monotone:
      return "No order in the " + name + ": answers scatter by " + error_text(order.fit.finest_error) +
             " instead of closing in.";
    case Convergence::not_expected:
      return "The " + name + ": answers differ by up to " + error_text(order.fit.spread) +
             ", and no order is expected.";
    case Convergence::within_scatter:
      return "The " + name + ": answers differ by up to " + error_text(order.fit.spread) +
             ", no more than repeats scatter.";
    case Convergence::order_assumed:
      return "Order in the " + name + ": too few runs; theory's " + number(*order.theory, 2) + " was taken.";
    case Convergence::converging:
      break;
  }
  const std::string where = order.axis == StudyAxis::time_step ? " in vibration" : "";
  return "Order in the " + name + ": " + format_decimals(order.fit.order, 2) + " (theory " + number(*order.theory, 2) +
         where + ")" + (order.runs.size() > 3 ? ", fits within " + error_text(order.fit.misfit) : "") +
         "; answers differ by up to " + error_text(order.fit.spread) + ".";
}

}  // namespace

std::string order_text(const AxisOrder& order) {
  std::string text = convergence_text(order, name_of(order.axis));
  if (!order.cut_runs.empty())
    text += " " + runs_text(order.cut_runs) + (order.cut_runs.size() > 1 ? " take" : " takes") +
            " no part: most of the steps had to be cut.";
  return text;
}

std::string recommendation_text(const AccuracyStudy& study) {
  const std::string target = "Target " + error_text(*study.target) + ": ";
  if (study.recommended < 0) return target + "no setting of this study meets it.";
  const AccuracyRow& row = study.rows[static_cast<std::size_t>(study.recommended)];
  return target + "run " + std::to_string(study.recommended) + " is the cheapest that meets it: " + row.label + ", " +
         error_of(row) + " in " + number(row.run->cpu_seconds, 3) + " s.";
}

std::string repeats_text(const AccuracyStudy& study) {
  if (study.repeats == 1) return {};
  std::string text = "Errors are of means of " + std::to_string(study.repeats) +
                     " runs, hardly changed; one run scatters about its mean by " +
                     error_text(study.scatter.value_or(0)) + " (standard deviation).";
  if (study.told_apart == false)
    text += " Settings differ by no more than that lets means differ by chance: no better setting can be told apart.";
  return text;
}

std::string study_text(const AccuracyStudy& study) {
  const bool repeated = study.repeats > 1;
  std::vector<std::string> head = {"",         "Run",      "Setting", "Error",      "CPU [s]",
                                   "Mesh [s]", "Unknowns", "Steps",   "Iterations", "Note"};
  if (repeated) head.insert(head.begin() + 4, "Spread");
  Table table(head, repeated ? "lrlrrrrrrrl" : "lrlrrrrrrl");
  for (const std::size_t i : by_cost(study)) {
    const AccuracyRow& row = study.rows[i];
    const StudyRun run = row.run.value_or(StudyRun{});
    std::vector<std::string> cells = {row.pareto ? "*" : "",
                                      std::to_string(i),
                                      row.label,
                                      error_of(row),
                                      number(run.cpu_seconds, 3),
                                      number(run.mesh_seconds, 3),
                                      std::to_string(run.dofs),
                                      std::to_string(run.steps),
                                      std::to_string(run.iterations),
                                      row.note};
    if (repeated) cells.insert(cells.begin() + 4, spread_of(row));
    table.add(cells);
  }
  std::string text = table.text() + "* no run that costs no more has less error.\n";
  text += study.known_answer ? "Errors are from the project's expect lines.\n"
                             : "Errors " + measure_text(study.measure) + " are from run " +
                                   std::to_string(study.reference) + ", ± its own estimated error.\n";
  if (repeated) text += paragraph(repeats_text(study), 0);
  for (const AxisOrder& order : study.orders) text += order_text(order) + '\n';
  for (const LeftOut& one : study.left_out) text += paragraph("Left out: " + one.what + ": " + one.reason, 0);
  if (study.target) text += paragraph(recommendation_text(study), 0);
  return text;
}

}  // namespace talus::cli
