#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace talus {

/// A number that may not be there is null in files.
inline nlohmann::ordered_json or_null(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

inline std::optional<double> number_or_none(const nlohmann::ordered_json& json) {
  return json.is_null() ? std::nullopt : std::optional<double>(json.get<double>());
}

}  // namespace talus
