#include <algorithm>

#include "model/number_text.hpp"
#include "model/tolerance_text.hpp"
#include "render/paint/numbers.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

Facts whole_run(const RunReport& report) {
  const double steps = std::max(1, report.steps);
  Facts facts;
  facts.rows = {
      {"Tolerance", tolerance_text(report.tolerance) + " (" + given(report.tolerance) + " of the largest force)"},
      {"Deepest penetration", quantity(report.max_penetration, "m", 2) + ", " +
                                  percent(report.max_relative_penetration) + " of the local mesh size"},
      {"Steps", count_text(report.steps) + ", " + format_number(static_cast<double>(report.iterations) / steps, 2) +
                    " open–close iterations each; " +
                    (report.cuts == 0 ? "no trial step was cut"
                                      : counted_text(report.cuts, "trial step was cut", "trial steps were cut"))},
      {"Wall time", clock_text(report.wall_seconds) + " on " + counted_text(report.threads, "thread", "threads") +
                        ", " + format_number(1e3 * report.wall_seconds / steps, 2) + " ms a step"}};
  return facts;
}

Table stage_by_stage(const RunRecord& run) {
  Table table{"Stage by stage",
              {"Stage", "Steps", "Mean step (s)", "Iterations a step", "Steps cut", "Contacts at most",
               "Penetration / mesh size", "Time error of a step (m)"},
              "lrrrrrrr",
              {}};
  const auto& names = run.results.stage_names();
  for (auto step = run.steps.begin(); step != run.steps.end();) {
    const int stage = step->stage;
    const auto end = std::find_if(step, run.steps.end(), [&](const StepReport& other) { return other.stage != stage; });
    long iterations = 0, cuts = 0, contacts = 0;
    double time = 0, deepest = 0, error = 0;
    for (auto one = step; one != end; ++one) {
      iterations += one->iterations;
      cuts += one->cuts;
      contacts = std::max<long>(contacts, one->contacts);
      time += one->time_step;
      deepest = std::max(deepest, one->max_relative_penetration);
      error = std::max(error, one->time_error);
    }
    const auto count = static_cast<double>(end - step);
    const auto number = static_cast<std::size_t>(stage);
    table.rows.push_back({number < names.size() && !names[number].empty() ? names[number] : std::to_string(stage + 1),
                          count_text(end - step), given(time / count),
                          format_number(static_cast<double>(iterations) / count, 2), count_text(cuts),
                          count_text(contacts), format_number(deepest, 2), format_number(error, 2)});
    step = end;
  }
  return table;
}

Table phases(const RunReport& report) {
  Table table{"Seconds by phase", {"Phase", "Time (s)", "Share"}, "lrr", {}};
  const auto add = [&](const char* name, double seconds) {
    table.rows.push_back(
        {name, format_number(seconds, 3), report.wall_seconds > 0 ? percent(seconds / report.wall_seconds) : "–"});
  };
  add("finding contacts", report.phases.detect);
  add("assembling equations", report.phases.assemble);
  add("factorising", report.phases.factor);
  add("solving", report.phases.solve);
  add("forces and states", report.phases.update);
  add("writing and watching", report.phases.write);
  return table;
}

Facts work(const RunWork& work) {
  Facts facts;
  facts.rows = {
      {"Contact points", count_text(work.contact_points) + " from " +
                             counted_text(work.facet_pairs, "pair of facets", "pairs of facets")},
      {"Equations", counted_text(work.factorisations, "sparse factorisation", "sparse factorisations") + ", " +
                        count_text(work.dense_factorisations) + " of small systems, " +
                        counted_text(work.linear_solves, "solve", "solves") + "; the largest system at the end has " +
                        count_text(3L * work.largest_system) + " unknowns"}};
  if (work.block_steps_asleep > 0)
    facts.rows.push_back(
        {"Sleep", "blocks slept through " + counted_text(work.block_steps_asleep, "step", "steps") + " in all"});
  return facts;
}

/// Limits that were reached, after which the run went on with what there was.
Paragraph limits(const RunWork& work) {
  std::string text;
  const auto add = [&](long count, const char* one, const char* many) {
    if (count > 0) text += (text.empty() ? "" : "; ") + counted_text(count, one, many);
  };
  add(work.correction_limits, "step used all rounds of correction", "steps used all rounds of correction");
  add(work.impact_sweep_limits, "solution of impulses used all its sweeps",
      "solutions of impulses used all their sweeps");
  add(work.gmres_limits, "linear solve used all GMRES iterations", "linear solves used all GMRES iterations");
  add(work.failed_factorisations, "attempt of the interior-point method had no factor",
      "attempts of the interior-point method had no factor");
  if (text.empty()) return {"No limit of the solver was reached.", Paragraph::Kind::plain};
  return {"Limits that were reached, after which the run went on with what there was: " + text + ".",
          Paragraph::Kind::plain};
}

}  // namespace

Section accuracy_and_cost(const RunRecord& run) {
  Section section{"Accuracy and cost", {}};
  if (run.report) section.parts.emplace_back(whole_run(*run.report));
  if (!run.steps.empty()) section.parts.emplace_back(stage_by_stage(run));
  if (!run.report) return section;
  section.parts.emplace_back(limits(run.report->work));
  section.parts.emplace_back(phases(*run.report));
  section.parts.emplace_back(work(run.report->work));
  return section;
}

}  // namespace talus::report
