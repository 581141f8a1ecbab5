#pragma once

#include <string>
#include <vector>

#include "verification/hard_cases/trial.hpp"

/// Hard cases as Markdown, without seconds, so that the same results give the same page.
namespace talus {

/// A scene's row: what it is, what it must come to, and its figures.
std::string trial_row(const Trial& trial);

/// A table a group, then what does not hold.
std::string hard_cases_page(const std::vector<Trial>& trials);

}  // namespace talus
