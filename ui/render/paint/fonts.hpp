#pragma once

#include <string>

namespace talus {

enum class FontWeight { regular, semibold };

/// File of the font that pictures are lettered with: Inter, or DejaVu Sans where that is not installed.
/// VTK's own font has no Greek and no superscripts. Throws std::runtime_error that names the package.
const std::string& font_file(FontWeight weight);

}  // namespace talus
