#include "report/pdf_column.hpp"

#include <pango/pangocairo.h>

#include <utility>

#include "render/paint/cairo_painter.hpp"

namespace talus::report {

namespace {

constexpr double a4_width = 595.28, a4_height = 841.89;
constexpr double first_line = 58, last_line = a4_height - 62, foot = a4_height - 44;
constexpr double leading = 1.18;  ///< of lines, over those of the font
constexpr Lettering foot_lettering{7.5, rgb(0x5d6873)};

/// "m/s" stays on one line.
void keep_units_whole(PangoLayout* layout, const std::string& text) {
  PangoAttrList* attributes = pango_attr_list_copy(pango_layout_get_attributes(layout));
  for (std::size_t at = text.find('/'); at != std::string::npos; at = text.find('/', at + 1)) {
    PangoAttribute* whole = pango_attr_allow_breaks_new(FALSE);
    whole->start_index = static_cast<guint>(at);
    whole->end_index = static_cast<guint>(at + 2);
    pango_attr_list_insert(attributes, whole);
  }
  pango_layout_set_attributes(layout, attributes);
  pango_attr_list_unref(attributes);
}

}  // namespace

TextBox::TextBox(cairo_t& context, const std::string& text, const Lettering& lettering, double width, bool right)
    : context_(context),
      layout_(new_layout(context, text, lettering.size, lettering.weight)),
      colour_(lettering.colour) {
  keep_units_whole(layout_, text);
  pango_layout_set_line_spacing(layout_, leading);
  pango_layout_set_wrap(layout_, PANGO_WRAP_WORD_CHAR);
  pango_layout_set_alignment(layout_, right ? PANGO_ALIGN_RIGHT : PANGO_ALIGN_LEFT);
  if (width > 0) pango_layout_set_width(layout_, pango_units_from_double(width));
}

TextBox::~TextBox() {
  if (layout_) g_object_unref(layout_);
}

TextBox::TextBox(TextBox&& other) noexcept
    : context_(other.context_), layout_(std::exchange(other.layout_, nullptr)), colour_(other.colour_) {}

double TextBox::width() const {
  int width = 0;
  pango_layout_get_size(layout_, &width, nullptr);
  return pango_units_to_double(width);
}

double TextBox::height() const {
  int height = 0;
  pango_layout_get_size(layout_, nullptr, &height);
  return pango_units_to_double(height);
}

void TextBox::paint(double left, double top) const {
  cairo_set_source_rgb(&context_, colour_.red / 255.0, colour_.green / 255.0, colour_.blue / 255.0);
  cairo_move_to(&context_, left, top);
  pango_cairo_show_layout(&context_, layout_);
}

PdfColumn::PdfColumn(const std::string& title) : title_(title), pages_(a4_width, a4_height, title), top_(first_line) {}

bool PdfColumn::keep_together(double height) {
  if (top_ + height <= last_line || top_ == first_line) return false;
  end_page();
  ++page_;
  top_ = first_line;
  return true;
}

void PdfColumn::text(const std::string& text, const Lettering& lettering) {
  const TextBox box(context(), text, lettering, width);
  keep_together(box.height());
  box.paint(left, top_);
  top_ += box.height();
}

void PdfColumn::rule(double from, double length, double thickness, Rgb colour) {
  cairo_t* context = &pages_.context();
  cairo_set_source_rgb(context, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  cairo_set_line_width(context, thickness);
  cairo_move_to(context, from, top_);
  cairo_line_to(context, from + length, top_);
  cairo_stroke(context);
}

void PdfColumn::end_page() {
  TextBox(context(), title_, foot_lettering).paint(left, foot);
  const TextBox number(context(), std::to_string(page_), foot_lettering);
  number.paint(left + width - number.width(), foot);
  pages_.end_page();
}

std::string PdfColumn::file() {
  end_page();
  return pages_.file();
}

}  // namespace talus::report
