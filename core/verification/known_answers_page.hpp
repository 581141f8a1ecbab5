#pragma once

#include <string>
#include <vector>

#include "verification/verify.hpp"

/// Known answers as Markdown, without seconds, so that the same results give the same page.
namespace talus {

/// A row of the overview: the case, its title, numbers held, and how near the worst comes to its tolerance.
std::string overview_row(const CaseResult& result);

/// A case's section: title, source, every quantity with its numbers, remarks and tables.
std::string case_section(const CaseResult& result);

/// The overview, then a section a case.
std::string known_answers_page(const std::vector<CaseResult>& results);

}  // namespace talus
