#pragma once

#include <string>

#include "verification/verify.hpp"

/// What a case came to, in words and rounded figures.
namespace talus {

/// Expected, computed, error and tolerance as they are read: an absolute error and tolerance with ± before it.
struct FindingWords {
  std::string expected, computed, error, tolerance, verdict;
};
FindingWords words_of(const Finding& finding);

/// A letter a column of the table, l or r: words to the left, numbers to the right.
std::string alignment_of(const CaseTable& table);

/// "2 threads: the same bits", "… the same; relative difference 3e-12 (acceleration)".
std::string repetition_text(const Repetition& repetition);

}  // namespace talus
