#pragma once

#include <CLI/App.hpp>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "render/paint/image.hpp"

namespace talus::cli {

/// What came of holding a picture against its baseline.
struct PictureVerdict {
  std::string problem{};    ///< in which way they differ, in one line; empty where they do not
  std::string agreement{};  ///< how alike they are, where they do not differ
  nlohmann::ordered_json json = nlohmann::ordered_json::object();  ///< the same as numbers
};

/// P.difference.png of a picture P.png.
std::filesystem::path difference_file(std::filesystem::path picture);

/// Holds what was drawn, and is told of as `picture`, against its baseline, tile by tile. Where they differ, and have
/// one size, `difference` is written, in a folder that is made: a picture of what was expected, what came, and what
/// differs. Throws InputError where the baseline is no readable picture, or the difference cannot be written.
PictureVerdict compare_with_baseline(const Image& drawn, const std::filesystem::path& picture,
                                     const std::filesystem::path& baseline, double threshold,
                                     const std::filesystem::path& difference);

/// Adds --threshold to a command.
CLI::Option* add_threshold(CLI::App& command, double& threshold);

}  // namespace talus::cli
