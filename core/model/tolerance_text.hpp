#pragma once

#include <optional>
#include <string>

namespace talus {

/// SolverSettings::tolerance in words: "standard", or "1e-5" where the number has no name.
std::string tolerance_text(double tolerance);

/// From a name, or a number in the range that projects allow; nothing for any other text.
std::optional<double> tolerance_from(const std::string& text);

}  // namespace talus
