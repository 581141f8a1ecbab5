#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace talus::cli {

/// What --json prints. Names of files need not be UTF-8, which JSON is: bytes that are none come out as U+FFFD.
inline std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace talus::cli
