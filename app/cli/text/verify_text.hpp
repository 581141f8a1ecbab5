#pragma once

#include <string>
#include <vector>

#include "verification/verify.hpp"

namespace talus::cli {

/// What the columns of a case's text mean; once, above the first case.
std::string case_columns();

/// A case for a reader: title, every quantity with its numbers, remarks, source, verdict; tables where asked for.
std::string case_text(const CaseResult& result, bool tables);

/// The list of cases there are.
std::string list_text(const std::vector<KnownCase>& cases);

}  // namespace talus::cli
