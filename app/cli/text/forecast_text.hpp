#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "study/forecast/forecast.hpp"

namespace talus::cli {

/// What is known of a run before it is made.
struct RunAhead {
  Forecast forecast;
  std::optional<double> studied_error;  ///< relative, of the project's accuracy study; it goes before the forecast's
};

/// Seconds, memory and error, each with where it comes from.
std::string forecast_text(const RunAhead& ahead);

/// The same; "error_from" is "study", "step doubling" or null.
nlohmann::ordered_json forecast_json(const RunAhead& ahead);

}  // namespace talus::cli
