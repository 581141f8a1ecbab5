#pragma once

#include "render/paint/painter.hpp"

using cairo_t = struct _cairo;
using PangoLayout = struct _PangoLayout;

namespace talus {

/// Paints through Cairo, on a PDF's page. The context's origin is the upper left corner of what is painted, its unit
/// the pixel; `height` is that of what is painted.
class CairoPainter final : public Painter {
 public:
  CairoPainter(cairo_t& context, double height) : context_(context), height_(height) {}

 private:
  void draw_rectangle(const PixelRect& rect, Rgb colour, double opacity) override;
  void draw_polygon(std::span<const PixelPoint> convex, Rgb colour, double opacity) override;
  void draw_line(std::span<const PixelPoint> points, double width, Rgb colour, double opacity) override;
  void draw_disc(PixelPoint centre, double radius, Rgb colour) override;
  void draw_text(PixelPoint at, std::string_view text, const TextStyle& style) override;
  void trace(std::span<const PixelPoint> points);
  void set_colour(Rgb colour, double opacity);

  cairo_t& context_;
  double height_;
};

/// A paragraph of Pango's in the letters of pictures, `height` units high, with figures of one width. It goes with the
/// caller's g_object_unref.
PangoLayout* new_layout(cairo_t& context, std::string_view text, double height, FontWeight weight);

}  // namespace talus
