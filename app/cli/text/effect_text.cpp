#include "text/effect_text.hpp"

#include <algorithm>

#include "model/number_text.hpp"
#include "model/rules/switched_effects.hpp"
#include "text/table.hpp"

namespace talus::cli {

namespace {

/// What the columns before the last one of the table of costs take.
constexpr std::size_t width_before_why = 41;

std::string paragraph(const std::string& text) {
  std::string lines;
  for (const std::string& line : wrapped(words_of(text), line_width)) lines += line + '\n';
  return lines;
}

/// On one line, or the items below the reason.
std::vector<std::string> reason_and_items(const EffectCost& cost) {
  constexpr std::size_t width = line_width - width_before_why;
  if (cost.items.empty()) return wrapped(words_of(cost.reason), width);
  const std::string together = cost.reason + ": " + cost.items;
  if (width_of(together) <= width) return {together};
  std::vector<std::string> lines = wrapped(words_of(cost.reason + ":"), width);
  for (const std::string& line : wrapped(words_of(cost.items), width)) lines.push_back(line);
  return lines;
}

std::string effects_that_were_on(const RunReport& report) {
  std::vector<EffectOutcome> on;
  for (const EffectOutcome& effect : report.effects)
    if (effect.active) on.push_back(effect);
  std::stable_sort(on.begin(), on.end(), [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
  Table table({"Effect", "Time [s]", "Share", "ms an iteration", "Evaluated", "Assembled"}, "lrrrrr");
  for (const EffectOutcome& effect : on) {
    const double share = report.wall_seconds > 0 ? 100 * effect.seconds / report.wall_seconds : 0;
    const double iterations = static_cast<double>(std::max(1L, report.iterations));
    table.add({effect.name, number(effect.seconds, 3), number(share, 2) + " %",
               number(1e3 * effect.seconds / iterations, 2), count_text(effect.evaluations),
               count_text(effect.assemblies)});
  }
  return table.text();
}

std::string effects_that_were_off(const RunReport& report) {
  std::string off;
  for (const EffectOutcome& effect : report.effects)
    if (!effect.active) off += (off.empty() ? "" : ", ") + effect.name;
  return off.empty() ? "" : paragraph("Off: " + off);
}

std::string phases_text(const Phases& phases) {
  return paragraph("Time by phase [s]: contacts " + number(phases.detect, 3) + ", assembly " +
                   number(phases.assemble, 3) + ", factors " + number(phases.factor, 3) + ", solving " +
                   number(phases.solve, 3) + ", forces " + number(phases.update, 3) + ", writing " +
                   number(phases.write, 3));
}

std::string sleep_text(const RunWork& work) {
  if (work.block_steps_asleep == 0) return "Sleep: no block slept\n";
  return paragraph("Sleep: blocks slept through " + counted_text(work.block_steps_asleep, "step", "steps") +
                   " in all, and were woken " + counted_text(work.wakings, "time", "times"));
}

std::string equations_text(const RunWork& work) {
  return paragraph("Equations: " + counted_text(work.factorisations, "sparse factorisation", "sparse factorisations") +
                   " and " + count_text(work.dense_factorisations) + " of small systems, " +
                   counted_text(work.linear_solves, "solve", "solves") + " with " +
                   counted_text(work.gmres_iterations, "GMRES iteration", "GMRES iterations") + "; at the end " +
                   counted_text(work.systems, "independent system", "independent systems") + ", the largest of " +
                   count_text(3L * work.largest_system) + " unknowns");
}

std::string contacts_text(const RunReport& report) {
  const RunWork& work = report.work;
  const double points = static_cast<double>(work.contact_points) / std::max(1, report.steps);
  return paragraph("Contacts: " + counted_text(work.contact_points, "point", "points") + " (" + number(points, 3) +
                   " a step) from " + counted_text(work.facet_pairs, "pair of facets", "pairs of facets") + "; " +
                   counted_text(work.body_pairs, "distance", "distances") + " of blocks measured, facets searched " +
                   counted_text(work.facet_searches, "time", "times"));
}

/// Limits that were reached, after which the run went on with what there was; nothing where none was.
std::string limits_text(const RunWork& work) {
  std::string text;
  const auto add = [&text](long count, const char* one, const char* many, const char* what) {
    if (count > 0) text += (text.empty() ? "" : "; ") + counted_text(count, one, many) + what;
  };
  add(work.correction_limits, "step", "steps", " used all rounds of correction");
  add(work.impact_sweep_limits, "step", "steps", " all sweeps of impulses");
  add(work.gmres_limits, "linear solve", "linear solves", " all GMRES iterations");
  add(work.failed_factorisations, "attempt", "attempts", " of the interior-point method had no LU factor");
  return text.empty() ? "" : paragraph("Limits reached: " + text);
}

}  // namespace

std::string costs_text(const std::vector<EffectCost>& costs) {
  Table table({"Effect", "", "ms (est.)", "Why, and of what"}, "llrl");
  double all = 0;
  for (const EffectCost& cost : costs) {
    const std::vector<std::string> lines = reason_and_items(cost);
    table.add({std::string(to_string(cost.kind)), cost.active ? "on" : "off",
               cost.active ? number(1e3 * cost.seconds, 2) : "0", lines[0]});
    for (std::size_t i = 1; i < lines.size(); ++i) table.add({"", "", "", lines[i]});
    all += cost.seconds;
  }
  return table.text() +
         paragraph("An open-close iteration is estimated to spend " + number(1e3 * all, 2) +
                   " ms on forces and stiffness on one thread, within a factor of two or so; finding contacts and "
                   "solving the equations come on top.");
}

std::string switched_effects_text(const Project& project) {
  std::string text;
  for (const ProjectProblem& one : problems_of_switched_effects(project))
    text += paragraph((one.kind == ProjectProblem::Kind::warning ? "warning: " : "note: ") + one.place + ": " +
                      one.problem + "; " + one.remedy);
  return text;
}

std::string profile_text(const RunReport& report) {
  if (report.effects.empty()) return "";
  return effects_that_were_on(report) + effects_that_were_off(report) + phases_text(report.phases) +
         contacts_text(report) + equations_text(report.work) + limits_text(report.work) + sleep_text(report.work) +
         "Stress: computed for " + counted_text(report.work.stress_recoveries, "block", "blocks") + " in all\n";
}

}  // namespace talus::cli
