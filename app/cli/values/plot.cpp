#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "render/charts/charts.hpp"
#include "text/json_text.hpp"
#include "text/report_text.hpp"
#include "text/terminal.hpp"
#include "values/block_charts.hpp"
#include "values/line_values.hpp"

namespace talus::cli {

namespace {

using Json = nlohmann::ordered_json;

struct PlotOptions {
  std::filesystem::path results, events;
  std::vector<std::string> monitors;
  BlockChoice blocks;  ///< of no blocks: monitors are plotted
  LineChoice line;
  ChartFiles files;
};

/// The monitors to plot, as indices into the results' own; all where none is named.
std::vector<int> chosen_monitors(const PlotOptions& options, const ResultReader& results) {
  const auto& names = results.monitor_names();
  if (names.empty())
    throw InputError("monitors", "the results hold no monitor", "add one to the project's monitors and solve it again");
  std::vector<int> chosen;
  for (const std::string& name : options.monitors.empty() ? names : options.monitors) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw InputError("monitor " + name, "the results hold no monitor of that name", "info lists them");
    chosen.push_back(static_cast<int>(found - names.begin()));
  }
  return chosen;
}

/// Published events with their computed moments, or else what the run itself noted.
std::vector<EventMark> marks_of(const std::vector<EventComparison>& comparisons, const std::vector<Event>& noted) {
  std::vector<EventMark> marks;
  for (const EventComparison& comparison : comparisons) {
    marks.push_back({comparison.event.time, comparison.event.what, true});
    if (comparison.computed) marks.push_back({*comparison.computed, comparison.event.what, false});
  }
  if (comparisons.empty())
    for (const Event& event : noted) marks.push_back({event.time, event.what, false});
  return marks;
}

/// Displacement, velocity and, where it was recorded, stress.
std::vector<Quantity::Field> fields_of(const HistoryMonitor& monitor) {
  std::vector<Quantity::Field> fields{Quantity::Field::displacement, Quantity::Field::velocity};
  if (monitor.stress) fields.push_back(Quantity::Field::stress);
  return fields;
}

const char* ending_of(Quantity::Field field) {
  if (field == Quantity::Field::displacement) return "-displacement";
  return field == Quantity::Field::velocity ? "-velocity" : "-stress";
}

Charts all_charts(const PlotOptions& options, const ResultReader& results, const std::vector<int>& monitors,
                  const std::vector<HistoryRow>& history, const std::vector<EventMark>& marks) {
  Charts rows;
  for (const int index : monitors) {
    const HistoryMonitor& monitor = results.history_monitors()[static_cast<std::size_t>(index)];
    std::vector<Chart>& row = rows.emplace_back();
    for (const Quantity::Field field : fields_of(monitor)) {
      HistoryPlot plot = monitor_plot(monitor.name, index, history, field);
      plot.marks = marks;
      plot.theme = options.files.theme;
      row.push_back({monitor.name + ending_of(field), std::move(plot)});
    }
  }
  return rows;
}

Json json_of(const std::vector<EventComparison>& comparisons) {
  Json array = Json::array();
  for (const EventComparison& c : comparisons)
    array.push_back({{"event", c.event.what},
                     {"published", c.event.time},
                     {"computed", c.computed ? Json(*c.computed) : Json()},
                     {"value_at_published", c.value_then ? Json(*c.value_then) : Json()}});
  return array;
}

ExitCode plot_monitors(const PlotOptions& options, const ResultReader& results, bool json) {
  const auto monitors = about(options.results, [&] { return chosen_monitors(options, results); });
  const auto history = results.history();
  if (history.empty())
    throw InputError(options.results.string(), "the history is empty", "wait for the run to make a step");
  std::vector<EventComparison> comparisons;
  if (!options.events.empty())
    comparisons = compare_events(read_reference_events(options.events), results.monitor_names(), history);
  const auto marks = marks_of(comparisons, results.report().value_or(RunReport{}).events);
  const auto files =
      write_charts(options.files, all_charts(options, results, monitors, history, marks), results.project_name());

  if (json) {
    const Json result = {{"pictures", files},
                         {"events", json_of(comparisons)},
                         {"in_published_order", comparisons.empty() ? Json() : Json(in_published_order(comparisons))}};
    std::cout << json_text(result) << '\n';
  } else {
    if (!comparisons.empty()) std::cout << events_text(comparisons);
    for (const std::string& file : files) std::cout << file << '\n';
  }
  return done;
}

ExitCode name(const std::vector<std::string>& files, bool json) {
  if (json)
    std::cout << json_text({{"files", files}}) << '\n';
  else
    for (const std::string& file : files) std::cout << file << '\n';
  return done;
}

ExitCode plot_blocks(const PlotOptions& options, const ResultReader& results, bool json) {
  catch_interrupts();
  const BlockHistory history = about(options.results, [&] { return chosen_history(options.blocks, results); });
  const std::vector<std::string> files =
      options.files.out.extension() == ".csv"
          ? write_table(options.files.out, history, options.blocks)
          : write_charts(options.files, block_charts(history, options.blocks, options.files.theme),
                         results.project_name());
  return name(files, json);
}

ExitCode plot(const PlotOptions& options, bool json) {
  const ResultReader results(options.results);
  if (!options.line.ends.empty())
    return name(about(options.results, [&] { return write_line(options.line, results, options.files); }), json);
  return options.blocks.names.empty() ? plot_monitors(options, results, json) : plot_blocks(options, results, json);
}

}  // namespace

void add_plot(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "plot", "Draw histories of monitors or of any blocks, or a field along a line, as PNG, SVG or PDF");
  auto options = std::make_shared<PlotOptions>();
  add_results(*command, options->results);
  command
      ->add_option(
          "--out", options->files.out,
          "Folder for a PNG of each chart; one sheet of all as PNG or SVG; a PDF of a page for each; of blocks "
          "and lines also the table as CSV")
      ->required()
      ->type_name("DIR|P.png|P.svg|P.pdf|T.csv");
  auto* monitor =
      command->add_option("--monitor", options->monitors, "Only this monitor; may be given again (default: all)")
          ->allow_extra_args(false)
          ->type_name("NAME");
  add_block_choice(*command, options->blocks, *monitor);
  add_line_choice(*command, options->line);
  command
      ->add_option("--events", options->events,
                   "Published events to mark and compare with: time [s],event,quantity,minus,reaches [m, m/s]")
      ->type_name("FILE.csv");
  add_size(*command, options->files.size);
  add_theme(*command, options->files.theme);
  command->callback([&invocation, options] {
    options->blocks.results = options->results;
    invocation.run = [&invocation, options] { return plot(*options, invocation.json); };
  });
}

}  // namespace talus::cli
