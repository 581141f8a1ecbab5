#pragma once

#include <string>
#include <vector>

#include "verification/hard_cases/trial.hpp"

namespace talus {

/// Random scenes as Markdown, without seconds, so that the same results give the same page: a row a family, then each
/// scene that does not hold by its name, with what does not.
std::string random_scenes_page(const std::vector<Trial>& trials);

}  // namespace talus
