#include "text/forecast_text.hpp"

#include "render/charts/log_axis.hpp"
#include "text/table.hpp"

namespace talus::cli {

namespace {

std::string error_sentence(const RunAhead& ahead) {
  if (!ahead.forecast.failure.empty()) return "It will not converge: " + ahead.forecast.failure + ".\n";
  if (ahead.studied_error) return "Its error is " + error_text(*ahead.studied_error) + " (accuracy study).\n";
  if (ahead.forecast.error)
    return "Its time steps leave out about " + error_text(*ahead.forecast.error) +
           " of the distance that blocks go (step doubling).\n";
  return "Its error is not known: try study accuracy.\n";
}

}  // namespace

std::string forecast_text(const RunAhead& ahead) {
  const Forecast& forecast = ahead.forecast;
  const bool made = forecast.share_seen >= 1;
  std::string text = "This run: about " + number(forecast.seconds, 2) + " s of the processor";
  if (!made) text += " (" + number(forecast.fewest, 2) + " to " + number(forecast.most, 2) + " s)";
  text += " for " + std::to_string(forecast.steps) + " steps, " + number(forecast.memory / 1e6, 2) + " MB.\n" +
          error_sentence(ahead);
  if (!made)
    text += number(100 * forecast.share_seen, 2) +
            " % of these seconds were measured, the others are foreseen; that took " +
            number(forecast.forecast_seconds, 2) + " s.\n";
  return text;
}

nlohmann::ordered_json forecast_json(const RunAhead& ahead) {
  using Json = nlohmann::ordered_json;
  const Forecast& forecast = ahead.forecast;
  const auto error = ahead.studied_error ? ahead.studied_error : forecast.error;
  return {{"seconds", forecast.seconds},
          {"fewest_seconds", forecast.fewest},
          {"most_seconds", forecast.most},
          {"memory", forecast.memory},
          {"steps", forecast.steps},
          {"share_seen", forecast.share_seen},
          {"failure", forecast.failure.empty() ? Json() : Json(forecast.failure)},
          {"error", error ? Json(*error) : Json()},
          {"error_from", ahead.studied_error ? Json("study")
                         : forecast.error    ? Json("step doubling")
                                             : Json()}};
}

}  // namespace talus::cli
