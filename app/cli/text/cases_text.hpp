#pragma once

#include <string>

#include "study/cases/case_study.hpp"

namespace talus::cli {

/// A line a case, then what all cases that completed say together.
std::string cases_text(const CaseStudy& study);

}  // namespace talus::cli
