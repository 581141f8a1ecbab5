#include "text/trial_text.hpp"

#include "text/paragraph.hpp"
#include "text/table.hpp"

namespace talus::cli {

namespace {

/// Widths are fixed because a scene is printed as soon as it ends, before those of the next are known.
constexpr std::size_t name_width = 36, ending_width = 13, figure_width = 11;

const std::vector<std::string> columns{"Scene",   "Ending", "Penetration", "Growth", "Iterations",
                                       "at most", "Cuts",   "Seconds",     "Holds"};

std::vector<std::string> cells_of(const Trial& trial) {
  return {trial.name,
          std::string(to_string(trial.ending)),
          number(trial.penetration, 2),
          number(trial.energy_growth, 2),
          number(trial.iterations_per_step(), 3),
          std::to_string(trial.most_iterations),
          std::to_string(trial.cuts),
          number(trial.seconds, 2),
          trial.passed() ? "yes" : "NO"};
}

std::string row_text(const std::vector<std::string>& cells) {
  std::string row = padded(cells[0], name_width) + "  " + padded(cells[1], ending_width);
  for (std::size_t i = 2; i + 1 < cells.size(); ++i) row += ' ' + padded_left(cells[i], figure_width);
  return row + "  " + cells.back() + '\n';
}

}  // namespace

std::string trial_columns() { return row_text(columns); }

std::string trial_text(const Trial& trial) {
  std::string text = row_text(cells_of(trial));
  for (const std::string& fault : faults(trial)) text += paragraph("– " + fault, 4);
  if (!trial.known_shortfall.empty() && !trial.passed()) text += paragraph("– known: " + trial.known_shortfall, 4);
  return text;
}

std::string list_text(const std::vector<HardCase>& scenes) {
  Table table({"Scene", "Group", "Runs", "Title"}, "llll");
  for (const HardCase& scene : scenes)
    table.add({scene.name, scene.group, scene.takes_long ? "with --all" : "always", scene.title});
  return table.text();
}

}  // namespace talus::cli
