#pragma once

#include "io/json_text.hpp"
#include "model/project.hpp"

namespace talus {

/// The whole project as JSON in the order of the contract. Empty lists, absent options and empty texts are left out;
/// everything else is there, defaults too.
OrderedJson project_to_json(const Project& project);

}  // namespace talus
