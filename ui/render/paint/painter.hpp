#pragma once

#include <vtkAbstractContextItem.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/paint/colour.hpp"
#include "render/paint/fonts.hpp"

class vtkContext2D;

namespace talus {

/// Pixels, y upwards from the picture's lower left corner.
struct PixelPoint {
  double x = 0, y = 0;
};
struct PixelRect {
  double left = 0, bottom = 0, right = 0, top = 0;
  double width() const { return right - left; }
  double height() const { return top - bottom; }
  bool operator==(const PixelRect&) const = default;
};

enum class AlignX { left, centre, right };
enum class AlignY { bottom, centre, top };

struct TextStyle {
  double height = 12;  ///< font size, pixels
  Rgb colour;
  FontWeight weight = FontWeight::regular;
  AlignX x = AlignX::left;
  AlignY y = AlignY::bottom;
  bool upwards = false;  ///< turned by 90°, read from the right
};

/// How far the baseline lies below the place that a text is aligned to, in text heights: a line reaches from 0.22 below
/// it to 0.78 above, its figures to 0.72.
constexpr double baseline_below(AlignY align) {
  return align == AlignY::bottom ? -0.22 : align == AlignY::centre ? 0.36 : 0.78;
}

/// Width of a line of text, pixels. Needs no GL context.
double text_width(std::string_view text, double height, FontWeight weight = FontWeight::regular);

/// Breaks a text between words so that no line is wider than `width` pixels (a longer word stays whole, and a number
/// keeps its per cent sign).
std::vector<std::string> wrapped(std::string_view text, double width, double height, FontWeight weight);

/// What overlays and charts are drawn with, in pixels: on the screen and into images (`ContextPainter`), or into
/// documents, whose lines stay lines and whose letters stay text (`SvgPainter`, `CairoPainter`).
class Painter {
 public:
  virtual ~Painter() = default;

  void fill(const PixelRect& rect, Rgb colour, double opacity = 1) { draw_rectangle(rect, colour, opacity); }
  void fill(std::span<const PixelPoint> convex, Rgb colour, double opacity = 1) {
    draw_polygon(convex, colour, opacity);
  }
  /// Filled and framed, with round corners.
  void card(const PixelRect& rect, double radius, Rgb fill, double fill_opacity, Rgb frame, double line_width);
  /// A line through all points, joins and ends round.
  void line(std::span<const PixelPoint> points, double width, Rgb colour, double opacity = 1) {
    draw_line(points, width, colour, opacity);
  }
  void line(PixelPoint a, PixelPoint b, double width, Rgb colour, double opacity = 1);
  void dashed(PixelPoint a, PixelPoint b, double width, double dash, Rgb colour);
  void disc(PixelPoint centre, double radius, Rgb colour) { draw_disc(centre, radius, colour); }
  void text(PixelPoint at, std::string_view text, const TextStyle& style) { draw_text(at, text, style); }

 private:
  virtual void draw_rectangle(const PixelRect& rect, Rgb colour, double opacity) = 0;
  virtual void draw_polygon(std::span<const PixelPoint> convex, Rgb colour, double opacity) = 0;
  virtual void draw_line(std::span<const PixelPoint> points, double width, Rgb colour, double opacity) = 0;
  virtual void draw_disc(PixelPoint centre, double radius, Rgb colour) = 0;
  virtual void draw_text(PixelPoint at, std::string_view text, const TextStyle& style) = 0;
};

/// Something that is painted at any size.
using Painting = std::function<void(Painter&, double width, double height)>;

/// Paints through VTK.
class ContextPainter final : public Painter {
 public:
  explicit ContextPainter(vtkContext2D& context) : context_(context) {}

 private:
  void draw_rectangle(const PixelRect& rect, Rgb colour, double opacity) override;
  void draw_polygon(std::span<const PixelPoint> convex, Rgb colour, double opacity) override;
  void draw_line(std::span<const PixelPoint> points, double width, Rgb colour, double opacity) override;
  void draw_disc(PixelPoint centre, double radius, Rgb colour) override;
  void draw_text(PixelPoint at, std::string_view text, const TextStyle& style) override;
  void set_brush(Rgb colour, double opacity);

  vtkContext2D& context_;
};

/// A layer of a VTK context scene that is drawn by a function.
class PainterItem : public vtkAbstractContextItem {
 public:
  static PainterItem* New();
  // clang-format off
  vtkTypeMacro(PainterItem, vtkAbstractContextItem)
      // clang-format on
      bool Paint(vtkContext2D* context) override;

  std::function<void(Painter&)> paint;
};

}  // namespace talus
