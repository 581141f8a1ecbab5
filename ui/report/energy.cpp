#include <cmath>

#include "render/charts/charts.hpp"
#include "render/paint/numbers.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

Chart accounts_over_time(const RunRecord& run, const Prefixed& unit) {
  HistoryPlot plot;
  plot.y_title = "Energy";
  plot.y_unit = unit.unit;
  const auto add = [&](const char* name, auto account) {
    Series series{name, {}, {}};
    for (const StepReport& step : run.steps) {
      series.x.push_back(step.time);
      series.y.push_back(unit.factor * account(step.energy));
    }
    plot.series.push_back(std::move(series));
  };
  add("kinetic", [](const EnergyLedger& e) { return e.kinetic; });
  add("potential", [](const EnergyLedger& e) { return e.potential; });
  add("elastic, contact", [](const EnergyLedger& e) { return e.elastic + e.contact; });
  add("friction", [](const EnergyLedger& e) { return e.friction_dissipated; });
  add("damping, loss", [](const EnergyLedger& e) { return e.damping_dissipated + e.integration_loss; });
  add("missing", [](const EnergyLedger& e) { return e.remainder; });
  return {chart_painting(plot), 700, 320,
          "Energies over time. Potential is that of weight and loads; damping holds impacts; loss is what the "
          "integration in "
          "time takes, by which static stages come to rest; missing is what the sum of all lacks."};
}

Table accounts_at_the_end(const EnergyLedger& energy, double moved, const Prefixed& unit) {
  Table table{
      "Accounts at the end", {"Account", "Energy (" + unit.unit + ")", "Of what moved", "What it is"}, "lrrl", {}};
  const auto add = [&](const char* name, double value, const char* meaning) {
    table.rows.push_back(
        {name, format_number(unit.factor * value, 4), moved > 0 ? percent(value / moved) : "–", meaning});
  };
  add("kinetic", energy.kinetic, "motion");
  add("elastic", energy.elastic, "strain of the rock");
  add("potential", energy.potential, "weight and loads, since the start");
  add("contact", energy.contact, "springs of contacts");
  add("friction", energy.friction_dissipated, "dissipated by sliding");
  add("damping", energy.damping_dissipated, "dissipated by damping and impacts");
  add("constraints", energy.constraint_work, "put in by held and moved points");
  add("integration loss", energy.integration_loss, "taken by the integration in time");
  add("missing", energy.remainder, "error of the ledger: the sum of all should be zero");
  return table;
}

}  // namespace

Section energy(const RunRecord& run) {
  Section section{"Energy", {}};
  if (run.steps.empty()) return section;
  const double moved = energy_moved(run.steps);
  const Prefixed unit = prefixed("J", moved);
  double worst = 0;
  for (const StepReport& step : run.steps) worst = std::max(worst, std::abs(step.energy.remainder));
  if (moved > 0)
    section.parts.emplace_back(
        Paragraph{"The ledger misses at most " + percent(worst / moved) + " of the " + quantity(moved, "J") +
                  " that moved, and " + percent(std::abs(run.steps.back().energy.remainder) / moved) + " at the end."});
  if (run.steps.size() > 1) section.parts.emplace_back(accounts_over_time(run, unit));
  section.parts.emplace_back(accounts_at_the_end(run.steps.back().energy, moved, unit));
  return section;
}

}  // namespace talus::report
