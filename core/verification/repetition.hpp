#pragma once

#include "verification/verify.hpp"

namespace talus {

/// How the second run of a case differs from the first. At the same scale they must agree to the bit, at another in
/// relative terms (see VerifyOptions::repeat).
Repetition compared(const CaseResult& first, const CaseResult& second);

}  // namespace talus
