#pragma once

#include <nlohmann/json.hpp>

#include "study/accuracy/setting.hpp"

namespace talus {

/// {"body", "strain", "integrator", "time_step", "static_step", "mesh_size", "penetration_tolerance", "tolerance",
/// "scheme"}; null where there is none.
nlohmann::ordered_json setting_json(const Setting& setting);

/// Throws nlohmann::json::exception for what is no setting.
Setting setting_of(const nlohmann::ordered_json& json);

}  // namespace talus
