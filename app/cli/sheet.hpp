#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "options.hpp"
#include "render/paint/painter.hpp"

namespace talus::cli {

/// Paintings of one size in rows.
struct Sheet {
  std::vector<std::vector<Painting>> rows;
  PictureSize size;
  Rgb paper;
  std::string title;  ///< of a PDF
};

/// Whether the file's ending is one that `write_sheet` writes.
bool is_sheet(const std::filesystem::path& file);

/// All of them on one PNG or SVG, or on a page each of a PDF, as the file's ending says. Throws InputError for another
/// ending, for sizes outside 320…8192, and where the file cannot be written.
void write_sheet(const Sheet& sheet, const std::filesystem::path& file);

}  // namespace talus::cli
