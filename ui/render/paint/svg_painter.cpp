#include "render/paint/svg_painter.hpp"

#include <cmath>
#include <cstdio>

#include "base/xml_text.hpp"

namespace talus {
namespace {

/// Hundredths of a pixel are fine enough, and keep long curves short.
std::string pixels(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value == 0 ? 0.0 : value);
  std::string trimmed(text);
  trimmed.erase(trimmed.find_last_not_of('0') + 1);
  if (trimmed.back() == '.') trimmed.pop_back();
  return trimmed == "-0" ? "0" : trimmed;
}

std::string hex(Rgb colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.red, colour.green, colour.blue);
  return text;
}

/// ` name="value"`
std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + '"';
}

std::string seen_through(double opacity) { return opacity < 1 ? attribute("opacity", pixels(opacity)) : ""; }

std::string filled(Rgb colour, double opacity) { return attribute("fill", hex(colour)) + seen_through(opacity); }

}  // namespace

SvgPainter::SvgPainter(double width, double height, Rgb paper) : width_(width), height_(height) {
  draw_rectangle({0, 0, width, height}, paper, 1);
}

std::string SvgPainter::element(double x, double y) const {
  return "<svg" + attribute("xmlns", "http://www.w3.org/2000/svg") + attribute("x", pixels(x)) +
         attribute("y", pixels(y)) + attribute("width", pixels(width_)) + attribute("height", pixels(height_)) +
         attribute("viewBox", "0 0 " + pixels(width_) + ' ' + pixels(height_)) +
         attribute("font-family", "Inter, 'DejaVu Sans', Arial, sans-serif") + ">\n" + shapes_ + "</svg>\n";
}

std::string SvgPainter::list_of(std::span<const PixelPoint> points) const {
  std::string list;
  for (const PixelPoint& point : points)
    list += (list.empty() ? "" : " ") + pixels(point.x) + ',' + pixels(height_ - point.y);
  return list;
}

void SvgPainter::draw_rectangle(const PixelRect& rect, Rgb colour, double opacity) {
  shapes_ += "<rect" + attribute("x", pixels(rect.left)) + attribute("y", pixels(height_ - rect.top)) +
             attribute("width", pixels(rect.width())) + attribute("height", pixels(rect.height())) +
             filled(colour, opacity) + "/>\n";
}

void SvgPainter::draw_polygon(std::span<const PixelPoint> convex, Rgb colour, double opacity) {
  shapes_ += "<polygon" + attribute("points", list_of(convex)) + filled(colour, opacity) + "/>\n";
}

void SvgPainter::draw_line(std::span<const PixelPoint> points, double width, Rgb colour, double opacity) {
  if (points.size() < 2) return;
  shapes_ += "<polyline" + attribute("points", list_of(points)) + attribute("fill", "none") +
             attribute("stroke", hex(colour)) + attribute("stroke-width", pixels(width)) +
             attribute("stroke-linejoin", "round") + attribute("stroke-linecap", "round") + seen_through(opacity) +
             "/>\n";
}

void SvgPainter::draw_disc(PixelPoint centre, double radius, Rgb colour) {
  shapes_ += "<circle" + attribute("cx", pixels(centre.x)) + attribute("cy", pixels(height_ - centre.y)) +
             attribute("r", pixels(radius)) + filled(colour, 1) + "/>\n";
}

void SvgPainter::draw_text(PixelPoint at, std::string_view text, const TextStyle& style) {
  const std::string x = pixels(at.x), y = pixels(height_ - at.y);
  std::string element = "<text" + attribute("x", x) + attribute("y", y) +
                        attribute("dy", pixels(baseline_below(style.y) * style.height)) +
                        attribute("font-size", pixels(style.height)) + attribute("fill", hex(style.colour));
  if (style.weight == FontWeight::semibold) element += attribute("font-weight", "600");
  if (style.x != AlignX::left) element += attribute("text-anchor", style.x == AlignX::centre ? "middle" : "end");
  if (style.upwards) element += attribute("transform", "rotate(-90 " + x + ' ' + y + ')');
  shapes_ += element + '>' + xml_text(std::string(text)) + "</text>\n";
}

std::string svg_document(double width, double height, const std::string& elements) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg" + attribute("xmlns", "http://www.w3.org/2000/svg") +
         attribute("width", pixels(width)) + attribute("height", pixels(height)) +
         attribute("viewBox", "0 0 " + pixels(width) + ' ' + pixels(height)) + ">\n" + elements + "</svg>\n";
}

}  // namespace talus
