#pragma once

#include <string>
#include <vector>

#include "render/paint/image.hpp"

namespace talus {

/// A run, foreseen and made; s of the processor.
struct ForecastPoint {
  double seconds = 0, fewest = 0, most = 0;
  double measured = 0;
  bool seen_whole = false;  ///< the forecast made the run itself
};

/// Foreseen against measured seconds, both logarithmic: the range of each forecast a bar, and a band of ± 30 % about
/// where they agree. Throws std::invalid_argument without points.
Image draw_forecast_chart(const std::string& title, const std::vector<ForecastPoint>& points, int width, int height);

}  // namespace talus
