#include "values/block_charts.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "output_file.hpp"
#include "project_choice.hpp"
#include "render/charts/block_plot.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

std::vector<BlockQuantity> quantities_of(const BlockChoice& choice) {
  std::vector<BlockQuantity> wanted;
  if (choice.quantities.empty())
    for (const char* usual : {"displacement", "speed", "rotation"}) wanted.push_back(block_quantity_named(usual));
  for (const std::string& name : choice.quantities) wanted.push_back(block_quantity_named(name));
  return wanted;
}

std::vector<int> blocks_of(const BlockChoice& choice, const BlockSystem& system) {
  std::vector<int> blocks;
  for (const std::string& name : choice.names) {
    const auto found = std::ranges::find(system.blocks, name, &Block::name);
    if (found == system.blocks.end())
      throw InputError("block " + name, "the results hold no block of that name", "info lists them");
    blocks.push_back(static_cast<int>(found - system.blocks.begin()));
  }
  return blocks;
}

/// Of the project's materials, as it was run; none where it is gone or no longer understood.
std::vector<double> densities_of_run(const std::filesystem::path& results) {
  ProjectChoice run;
  run.file = results / "project.talus";
  run.reading.allow_outside = true;  // no file that it names is opened
  try {
    std::vector<double> densities;
    for (const Material& material : read(run).materials) densities.push_back(material.density);
    return densities;
  } catch (const InputError&) {
    return {};
  }
}

std::string quantity_names() {
  std::string names;
  for (const BlockQuantity& quantity : all_block_quantities())
    names += (names.empty() ? "" : ", ") + std::string(quantity.name);
  return names;
}

}  // namespace

void add_block_choice(CLI::App& command, BlockChoice& choice, CLI::Option& monitor) {
  auto* block = command
                    .add_option("--block", choice.names,
                                "This block in place of monitors; may be given again, for up to six curves a chart")
                    ->allow_extra_args(false)
                    ->type_name("NAME")
                    ->excludes(&monitor);
  command
      .add_option("--quantity", choice.quantities,
                  "What of the blocks, a chart each; may be given again (default: displacement, speed and rotation): " +
                      quantity_names())
      ->allow_extra_args(false)
      ->type_name("NAME")
      ->needs(block);
}

BlockHistory chosen_history(const BlockChoice& choice, const ResultReader& results) {
  quantities_of(choice);  // before time is spent
  const std::vector<int> blocks = blocks_of(choice, results.system());
  if (blocks.size() > most_curves)
    throw InputError("--block", "a chart shows six blocks at most", "plot the others into another file");
  TerminalProgress progress;
  BlockHistory history = block_history(results, blocks, densities_of_run(choice.results), progress);
  if (history.times.empty())
    throw InputError("frames", "the results hold no frame yet", "wait for the run to write one");
  return history;
}

Charts block_charts(const BlockHistory& history, const BlockChoice& choice, Theme theme) {
  Charts charts;
  for (const BlockQuantity& quantity : quantities_of(choice)) {
    HistoryPlot plot = block_plot(history, quantity);
    plot.theme = theme;
    charts.push_back({{"blocks-" + std::string(quantity.name), std::move(plot)}});
  }
  return charts;
}

std::vector<std::string> write_table(const std::filesystem::path& file, const BlockHistory& history,
                                     const BlockChoice& choice) {
  write_output(file, history_csv(history, quantities_of(choice)));
  return {file.string()};
}

}  // namespace talus::cli
