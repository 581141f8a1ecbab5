#pragma once

#include <CLI/App.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "measures/block_history.hpp"
#include "values/chart_files.hpp"

namespace talus::cli {

/// Blocks, and what of them is plotted.
struct BlockChoice {
  std::filesystem::path results;
  std::vector<std::string> names, quantities;
};

/// Adds `--block` and `--quantity`; blocks are plotted in place of what `monitor` chooses.
void add_block_choice(CLI::App& command, BlockChoice& choice, CLI::Option& monitor);

/// Throws InputError for blocks and quantities there are not, Cancelled.
BlockHistory chosen_history(const BlockChoice& choice, const ResultReader& results);

/// A chart a quantity, a curve a block.
Charts block_charts(const BlockHistory& history, const BlockChoice& choice, Theme theme);

/// The same as a table; returns the file. Throws InputError where it cannot be written.
std::vector<std::string> write_table(const std::filesystem::path& file, const BlockHistory& history,
                                     const BlockChoice& choice);

}  // namespace talus::cli
