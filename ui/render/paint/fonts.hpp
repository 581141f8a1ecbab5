#pragma once

#include <string>

namespace talus {

enum class FontWeight { regular, semibold };

/// File of the font that pictures are lettered with: Inter as it was installed with the program, or the system's, or
/// DejaVu Sans where neither is there.
/// VTK's own font has no Greek and no superscripts. Throws std::runtime_error that names the package.
const std::string& font_file(FontWeight weight);

}  // namespace talus
