#pragma once

#include <filesystem>

#include "study/accuracy/accuracy.hpp"

namespace talus {

/// A study from its accuracy.json alone, as `accuracy_json` wrote it: all but the answers of its runs, from which
/// errors came. Throws InputError for a file that is none.
AccuracyStudy read_accuracy_json(const std::filesystem::path& file);

}  // namespace talus
