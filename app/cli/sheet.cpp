#include "sheet.hpp"

#include <algorithm>

#include "command.hpp"
#include "output_file.hpp"
#include "render/charts/painted_image.hpp"
#include "render/paint/pdf_pages.hpp"
#include "render/paint/svg_painter.hpp"

namespace talus::cli {

namespace {

std::size_t columns_of(const Sheet& sheet) {
  std::size_t columns = 0;
  for (const auto& row : sheet.rows) columns = std::max(columns, row.size());
  return columns;
}

/// Paper where a row is shorter than others.
Image png_sheet(const Sheet& sheet) {
  const std::size_t columns = columns_of(sheet);
  const auto [width, height] = sheet.size;
  Image whole(static_cast<int>(columns) * width, static_cast<int>(sheet.rows.size()) * height);
  for (std::size_t i = 0; i < whole.rgb.size(); i += 3) {
    whole.rgb[i] = sheet.paper.red;
    whole.rgb[i + 1] = sheet.paper.green;
    whole.rgb[i + 2] = sheet.paper.blue;
  }
  const auto row_bytes = static_cast<std::size_t>(width) * 3;
  const auto lines = static_cast<std::size_t>(height);
  for (std::size_t r = 0; r < sheet.rows.size(); ++r)
    for (std::size_t c = 0; c < sheet.rows[r].size(); ++c) {
      const Image one = painted_image(width, height, sheet.paper, sheet.rows[r][c]);
      for (std::size_t y = 0; y < lines; ++y)
        std::copy_n(one.rgb.begin() + static_cast<std::ptrdiff_t>(y * row_bytes), row_bytes,
                    whole.rgb.begin() + static_cast<std::ptrdiff_t>(((r * lines + y) * columns + c) * row_bytes));
    }
  return whole;
}

std::string svg_sheet(const Sheet& sheet) {
  const double width = sheet.size.width, height = sheet.size.height;
  std::string elements;
  for (std::size_t r = 0; r < sheet.rows.size(); ++r)
    for (std::size_t c = 0; c < sheet.rows[r].size(); ++c) {
      SvgPainter painter(width, height, sheet.paper);
      sheet.rows[r][c](painter, width, height);
      elements += painter.element(static_cast<double>(c) * width, static_cast<double>(r) * height);
    }
  return svg_document(static_cast<double>(columns_of(sheet)) * width, static_cast<double>(sheet.rows.size()) * height,
                      elements);
}

std::string pdf_sheet(const Sheet& sheet) {
  std::vector<Painting> pages;
  for (const auto& row : sheet.rows)
    for (const Painting& painting : row)
      pages.push_back([&](Painter& painter, double width, double height) {
        painter.fill(PixelRect{0, 0, width, height}, sheet.paper);
        painting(painter, width, height);
      });
  return pdf_of(sheet.size.width, sheet.size.height, sheet.title, pages);
}

}  // namespace

bool is_sheet(const std::filesystem::path& file) {
  const std::string ending = file.extension();
  return ending == ".png" || ending == ".svg" || ending == ".pdf";
}

void write_sheet(const Sheet& sheet, const std::filesystem::path& file) {
  if (!is_sheet(file))
    throw InputError(file.string(), "pictures are written as PNG, SVG or PDF",
                     "let the name end in .png, .svg or .pdf");
  if (file.extension() == ".png")
    write_png(png_sheet(sheet), file);
  else
    write_output(file, file.extension() == ".svg" ? svg_sheet(sheet) : pdf_sheet(sheet));
}

}  // namespace talus::cli
