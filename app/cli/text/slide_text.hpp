#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "measures/slide.hpp"

namespace talus::cli {

/// What a slide came to, for a reader.
std::string slide_text(const Slide& slide, const BlockSystem& system);

/// The same, with the front at every frame and the deposit's outline.
nlohmann::ordered_json slide_json(const Slide& slide, const BlockSystem& system);

}  // namespace talus::cli
