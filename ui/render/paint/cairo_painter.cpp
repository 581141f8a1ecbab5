#include "render/paint/cairo_painter.hpp"

#include <pango/pangocairo.h>

#include <numbers>

namespace talus {

void CairoPainter::set_colour(Rgb colour, double opacity) {
  cairo_set_source_rgba(&context_, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0, opacity);
}

void CairoPainter::trace(std::span<const PixelPoint> points) {
  cairo_new_path(&context_);
  for (const PixelPoint& point : points) cairo_line_to(&context_, point.x, height_ - point.y);
}

void CairoPainter::draw_rectangle(const PixelRect& rect, Rgb colour, double opacity) {
  set_colour(colour, opacity);
  cairo_new_path(&context_);
  cairo_rectangle(&context_, rect.left, height_ - rect.top, rect.width(), rect.height());
  cairo_fill(&context_);
}

void CairoPainter::draw_polygon(std::span<const PixelPoint> convex, Rgb colour, double opacity) {
  set_colour(colour, opacity);
  trace(convex);
  cairo_fill(&context_);
}

void CairoPainter::draw_line(std::span<const PixelPoint> points, double width, Rgb colour, double opacity) {
  set_colour(colour, opacity);
  trace(points);
  cairo_set_line_width(&context_, width);
  cairo_set_line_join(&context_, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(&context_, CAIRO_LINE_CAP_ROUND);
  cairo_stroke(&context_);
}

void CairoPainter::draw_disc(PixelPoint centre, double radius, Rgb colour) {
  set_colour(colour, 1);
  cairo_new_path(&context_);
  cairo_arc(&context_, centre.x, height_ - centre.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(&context_);
}

void CairoPainter::draw_text(PixelPoint at, std::string_view text, const TextStyle& style) {
  PangoLayout* layout = new_layout(context_, text, style.height, style.weight);
  int width = 0;
  pango_layout_get_size(layout, &width, nullptr);
  const double share = style.x == AlignX::left ? 0 : style.x == AlignX::centre ? 0.5 : 1;
  cairo_save(&context_);
  cairo_translate(&context_, at.x, height_ - at.y);
  if (style.upwards) cairo_rotate(&context_, -std::numbers::pi / 2);
  cairo_move_to(
      &context_, -share * width / PANGO_SCALE,
      baseline_below(style.y) * style.height - static_cast<double>(pango_layout_get_baseline(layout)) / PANGO_SCALE);
  set_colour(style.colour, 1);
  pango_cairo_show_layout(&context_, layout);
  cairo_restore(&context_);
  g_object_unref(layout);
}

PangoLayout* new_layout(cairo_t& context, std::string_view text, double height, FontWeight weight) {
  PangoLayout* layout = pango_cairo_create_layout(&context);
  PangoFontDescription* font = pango_font_description_from_string("Inter, DejaVu Sans");
  pango_font_description_set_absolute_size(font, height * PANGO_SCALE);
  pango_font_description_set_weight(font, weight == FontWeight::semibold ? PANGO_WEIGHT_SEMIBOLD : PANGO_WEIGHT_NORMAL);
  pango_layout_set_font_description(layout, font);
  pango_font_description_free(font);
  PangoAttrList* attributes = pango_attr_list_new();
  pango_attr_list_insert(attributes, pango_attr_font_features_new("tnum=1"));
  pango_layout_set_attributes(layout, attributes);
  pango_attr_list_unref(attributes);
  pango_layout_set_text(layout, text.data(), static_cast<int>(text.size()));
  return layout;
}

}  // namespace talus
