#pragma once

#include <string>
#include <vector>

#include "stability/trial.hpp"

namespace talus::cli {

/// What the columns of a scene's row mean; once, above the first scene.
std::string trial_columns();
/// A scene's row, and below it in words what did not hold.
std::string trial_text(const Trial& trial);

/// The trials as Markdown: a table a group, then what did not hold.
std::string markdown_of(const std::vector<Trial>& trials);

/// The list of scenes there are.
std::string list_text(const std::vector<StabilityScene>& scenes);

}  // namespace talus::cli
