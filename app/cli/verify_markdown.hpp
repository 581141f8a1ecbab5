#pragma once

#include <string>
#include <vector>

#include "study/verify.hpp"

namespace talus::cli {

/// The results as Markdown: an overview, then a section a case.
std::string markdown_of(const std::vector<CaseResult>& results);

}  // namespace talus::cli
