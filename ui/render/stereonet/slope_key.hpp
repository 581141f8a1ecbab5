#pragma once

#include <string>
#include <vector>

#include "render/stereonet/stereonet.hpp"

namespace talus {

/// What a curve, an area or a symbol that belongs to the slope means.
struct SlopeKeyRow {
  enum class Sample { line, dashes, area, cross, dot };
  Sample sample = Sample::line;
  Rgb colour{};
  double width = 1;  ///< of the line, as NetLine has it
  std::string words, value;
};

/// Of a net with a slope, from top to bottom; empty without one.
std::vector<SlopeKeyRow> slope_key(const Stereonet& net);

}  // namespace talus
