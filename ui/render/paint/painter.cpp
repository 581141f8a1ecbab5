#include "render/paint/painter.hpp"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkVector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <sstream>

namespace talus {

vtkStandardNewMacro(PainterItem)

    namespace {
  constexpr int dots_per_inch = 72;  ///< one point is one pixel

  /// VTK has one cache of fonts and glyphs for all threads, and nothing guards it: a film that is written while the
  /// view is drawn letters at the same time. All text of pictures goes through this file, one thread at a time.
  std::mutex& lettering() {
    static std::mutex mutex;
    return mutex;
  }

  void apply(const TextStyle& style, vtkTextProperty& property) {
    property.SetFontFamily(VTK_FONT_FILE);
    property.SetFontFile(font_file(style.weight).c_str());
    property.SetFontSize(std::max(1, static_cast<int>(std::lround(style.height))));
    property.SetColor(style.colour.red / 255.0, style.colour.green / 255.0, style.colour.blue / 255.0);
    property.SetOpacity(1);
    property.SetOrientation(style.upwards ? 90 : 0);
    property.SetJustification(style.x == AlignX::left     ? VTK_TEXT_LEFT
                              : style.x == AlignX::centre ? VTK_TEXT_CENTERED
                                                          : VTK_TEXT_RIGHT);
    property.SetVerticalJustification(style.y == AlignY::bottom   ? VTK_TEXT_BOTTOM
                                      : style.y == AlignY::centre ? VTK_TEXT_CENTERED
                                                                  : VTK_TEXT_TOP);
  }

  std::vector<PixelPoint> arc(PixelPoint centre, double radius, double from, double to) {
    const int pieces = std::max(4, static_cast<int>(std::ceil(std::abs(to - from) * std::sqrt(radius) * 2)));
    std::vector<PixelPoint> points;
    for (int i = 0; i <= pieces; ++i) {
      const double angle = from + (to - from) * i / pieces;
      points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return points;
  }

  /// One thread at a time. VTK keeps the first property that it meets with a font, to open that font again when it was
  /// thrown out of the cache: it must be one that stays as it is, not that of a drawing, which takes up other fonts.
  std::array<int, 4> box_around(std::string_view text, vtkTextProperty & property) {
    std::array<int, 4> box = {0, -1, 0, -1};
    vtkTextRenderer::GetInstance()->GetBoundingBox(&property, vtkStdString(std::string(text)), box.data(),
                                                   dots_per_inch);
    return box;
  }

}  // namespace

double text_width(std::string_view text, double height, FontWeight weight) {
  vtkNew<vtkTextProperty> property;
  apply({.height = height, .colour = {}, .weight = weight}, *property);
  const std::lock_guard one_thread(lettering());
  const auto box = box_around(text, *property);
  return std::max(0, box[1] - box[0] + 1);
}

std::vector<std::string> wrapped(std::string_view text, double width, double height, FontWeight weight) {
  std::vector<std::string> words, lines;
  std::istringstream stream{std::string(text)};
  for (std::string word; stream >> word;)
    if (word.front() == '%' && !words.empty())  // stays with its number
      words.back() += " " + word;
    else
      words.push_back(std::move(word));
  for (const std::string& word : words) {
    if (!lines.empty() && text_width(lines.back() + " " + word, height, weight) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

void ContextPainter::set_brush(Rgb colour, double opacity) {
  context_.GetPen()->SetLineType(vtkPen::NO_PEN);
  context_.GetBrush()->SetColor(colour.red, colour.green, colour.blue,
                                static_cast<unsigned char>(std::lround(255 * opacity)));
}

void ContextPainter::draw_rectangle(const PixelRect& rect, Rgb colour, double opacity) {
  set_brush(colour, opacity);
  context_.DrawRect(static_cast<float>(rect.left), static_cast<float>(rect.bottom), static_cast<float>(rect.width()),
                    static_cast<float>(rect.height()));
}

void ContextPainter::draw_polygon(std::span<const PixelPoint> convex, Rgb colour, double opacity) {
  set_brush(colour, opacity);
  std::vector<float> points;
  for (const PixelPoint& p : convex) points.insert(points.end(), {static_cast<float>(p.x), static_cast<float>(p.y)});
  context_.DrawPolygon(points.data(), static_cast<int>(convex.size()));
}

void Painter::card(const PixelRect& rect, double radius, Rgb inside, double fill_opacity, Rgb frame,
                   double line_width) {
  constexpr double quarter = std::numbers::pi / 2;
  std::vector<PixelPoint> outline;
  const PixelPoint centres[] = {{rect.right - radius, rect.top - radius},
                                {rect.left + radius, rect.top - radius},
                                {rect.left + radius, rect.bottom + radius},
                                {rect.right - radius, rect.bottom + radius}};
  for (int i = 0; i < 4; ++i) {
    const auto corner = arc(centres[i], radius, i * quarter, (i + 1) * quarter);
    outline.insert(outline.end(), corner.begin(), corner.end());
  }
  fill(outline, inside, fill_opacity);
  outline.push_back(outline.front());
  line(outline, line_width, frame);
}

void ContextPainter::draw_line(std::span<const PixelPoint> points, double width, Rgb colour, double opacity) {
  // Quads and, where it bends, discs: VTK's own wide lines leave notches at the joins.
  const double half = width / 2;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const PixelPoint a = points[i - 1], b = points[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length == 0) continue;
    const double dx = (b.x - a.x) / length * half, dy = (b.y - a.y) / length * half;
    const PixelPoint quad[] = {{a.x + dy, a.y - dx}, {b.x + dy, b.y - dx}, {b.x - dy, b.y + dx}, {a.x - dy, a.y + dx}};
    fill(quad, colour, opacity);
    if (i + 1 < points.size() && width > 1.5) disc(b, half, colour);
  }
}

void Painter::line(PixelPoint a, PixelPoint b, double width, Rgb colour, double opacity) {
  const PixelPoint points[] = {a, b};
  line(points, width, colour, opacity);
}

void Painter::dashed(PixelPoint a, PixelPoint b, double width, double dash, Rgb colour) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const auto at = [&](double s) { return PixelPoint{a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length}; };
  for (double s = 0; s < length; s += 2 * dash) line(at(s), at(std::min(s + dash, length)), width, colour);
}

void ContextPainter::draw_disc(PixelPoint centre, double radius, Rgb colour) {
  const auto outline = arc(centre, radius, 0, 2 * std::numbers::pi);
  fill(outline, colour);
}

void ContextPainter::draw_text(PixelPoint at, std::string_view text, const TextStyle& style) {
  vtkNew<vtkTextProperty> property;
  apply(style, *property);
  const std::lock_guard one_thread(lettering());
  box_around(" ", *property);  // makes the font known
  context_.ApplyTextProp(property);
  context_.DrawString(static_cast<float>(std::round(at.x)), static_cast<float>(std::round(at.y)),
                      std::string(text).c_str());
}

bool PainterItem::Paint(vtkContext2D* context) {
  ContextPainter painter(*context);
  if (paint) paint(painter);
  return true;
}

}  // namespace talus
