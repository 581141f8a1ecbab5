#pragma once

#include <string>
#include <vector>

#include "study/verify.hpp"

namespace talus::cli {

/// What the columns of a case's text mean; once, above the first case.
std::string case_columns();

/// A case for a reader: title, every quantity with its numbers, remarks, source, verdict; tables where asked for.
std::string case_text(const CaseResult& result, bool tables);

/// The list of cases there are.
std::string list_text(const std::vector<KnownCase>& cases);

/// Expected, computed, error and tolerance as they are read: an absolute error and tolerance with ± before it.
struct FindingWords {
  std::string expected, computed, error, tolerance, verdict;
};
FindingWords words_of(const Finding& finding);

/// For `Table`: a letter a column, l or r.
std::string alignment_of(const CaseTable& table);

/// "2 threads: the same bits", "… the same; relative difference 3e-12 (acceleration)".
std::string repetition_text(const Repetition& repetition);

}  // namespace talus::cli
