#pragma once

#include "io/json_text.hpp"
#include "model/project.hpp"

namespace talus {

/// The project that a JSON value describes. The value must have passed `check_against_schema`; what it leaves out
/// keeps the default of model/project.hpp.
Project project_from_json(const OrderedJson& value);

}  // namespace talus
