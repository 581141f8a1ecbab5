#pragma once

#include "render/paint/painter.hpp"

namespace talus {

/// Paints an SVG element of `width` × `height` pixels.
class SvgPainter final : public Painter {
 public:
  SvgPainter(double width, double height, Rgb paper);

  /// The element as it is now; `x`, `y`: its upper left corner in an element around it.
  std::string element(double x = 0, double y = 0) const;

 private:
  void draw_rectangle(const PixelRect& rect, Rgb colour, double opacity) override;
  void draw_polygon(std::span<const PixelPoint> convex, Rgb colour, double opacity) override;
  void draw_line(std::span<const PixelPoint> points, double width, Rgb colour, double opacity) override;
  void draw_disc(PixelPoint centre, double radius, Rgb colour) override;
  void draw_text(PixelPoint at, std::string_view text, const TextStyle& style) override;
  /// "x,y x,y …", y downwards.
  std::string list_of(std::span<const PixelPoint> points) const;

  double width_, height_;
  std::string shapes_;
};

/// The file of an SVG picture: its outermost element, with what makes it a document of its own.
std::string svg_document(double width, double height, const std::string& elements);

}  // namespace talus
