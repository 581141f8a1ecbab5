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

/// Width of a line of text, pixels. Needs no GL context.
double text_width(std::string_view text, double height, FontWeight weight = FontWeight::regular);

/// Breaks a text between words so that no line is wider than `width` pixels (a longer word stays whole, and a number
/// keeps its per cent sign).
std::vector<std::string> wrapped(std::string_view text, double width, double height, FontWeight weight);

/// What overlays and charts are drawn with, in pixels.
class Painter {
 public:
  explicit Painter(vtkContext2D& context) : context_(context) {}

  void fill(const PixelRect& rect, Rgb colour, double opacity = 1);
  void fill(std::span<const PixelPoint> convex, Rgb colour, double opacity = 1);
  /// Filled and framed, with round corners.
  void card(const PixelRect& rect, double radius, Rgb fill, double fill_opacity, Rgb frame, double line_width);
  /// A line through all points, joins and ends round.
  void line(std::span<const PixelPoint> points, double width, Rgb colour, double opacity = 1);
  void line(PixelPoint a, PixelPoint b, double width, Rgb colour, double opacity = 1);
  void dashed(PixelPoint a, PixelPoint b, double width, double dash, Rgb colour);
  void disc(PixelPoint centre, double radius, Rgb colour);
  void text(PixelPoint at, std::string_view text, const TextStyle& style);

 private:
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
