#include "report/pdf.hpp"

#include <cairo.h>

#include <algorithm>
#include <cstdint>

#include "render/paint/cairo_painter.hpp"
#include "report/pdf_column.hpp"
#include "report/table_layout.hpp"

namespace talus::report {

namespace {

constexpr Rgb ink = rgb(0x1d2329), lesser_ink = rgb(0x5d6873), hairline_colour = rgb(0xdde1e5);
constexpr Lettering title_letters{20, ink, FontWeight::semibold}, heading_letters{13, ink, FontWeight::semibold},
    table_title_letters{9.5, ink, FontWeight::semibold}, text_letters{9.2, ink}, note_letters{8.2, lesser_ink},
    head_letters{7.8, ink, FontWeight::semibold}, cell_letters{7.8, ink}, name_letters{8.8, lesser_ink},
    value_letters{8.8, ink}, verdict_letters{11, ink, FontWeight::semibold};
constexpr double column_gap = 11, cell_padding = 2.6, room_for_some_rows = 62;

void write(PdfColumn& column, const Paragraph& paragraph) {
  if (paragraph.kind == Paragraph::Kind::plain || paragraph.kind == Paragraph::Kind::note) {
    column.text(paragraph.text, paragraph.kind == Paragraph::Kind::note ? note_letters : text_letters);
    column.go_down(5);
    return;
  }
  const bool good = paragraph.kind == Paragraph::Kind::good;
  const TextBox text(column.context(), paragraph.text, verdict_letters, PdfColumn::width - 20);
  const double height = text.height() + 14;
  column.keep_together(height);
  CairoPainter painter(column.context(), 0);
  const auto bar = [&](double from, double to, Rgb colour) {
    painter.fill(PixelRect{from, -column.top() - height, to, -column.top()}, colour);
  };
  bar(PdfColumn::left, PdfColumn::left + PdfColumn::width, good ? rgb(0xeef7f1) : rgb(0xfbefee));
  bar(PdfColumn::left, PdfColumn::left + 3.5, good ? rgb(0x2e7d4f) : rgb(0xb3372f));
  text.paint(PdfColumn::left + 12, column.top() + 7);
  column.go_down(height + 8);
}

void write(PdfColumn& column, const Facts& facts) {
  double names = 0;
  for (const auto& [name, value] : facts.rows)
    names = std::max(names, TextBox(column.context(), name, name_letters).width());
  const double indent = names + 16;
  for (const auto& [name, value] : facts.rows) {
    const TextBox left(column.context(), name, name_letters);
    const TextBox right(column.context(), value, value_letters, PdfColumn::width - indent);
    const double height = std::max(left.height(), right.height());
    column.keep_together(height);
    left.paint(PdfColumn::left, column.top());
    right.paint(PdfColumn::left + indent, column.top());
    column.go_down(height + 2.5);
  }
  column.go_down(7);
}

/// A table: a short one on one page, a long one from page to page under its heads.
class TableWriter {
 public:
  TableWriter(PdfColumn& column, const Table& table) : column_(column), table_(table) {
    std::vector<ColumnNeed> needs;
    for (std::size_t i = 0; i < table.heads.size(); ++i) needs.push_back(need_of(i));
    widths_ = column_widths(needs, PdfColumn::width - column_gap * static_cast<double>(needs.size() - 1));
    for (const double width : widths_) length_ += width + column_gap;
    length_ -= column_gap;
  }

  /// What of it stands on one page: all of a short one, some rows of a long one.
  double kept_together() const {
    constexpr double short_table = 250, around = 24;
    double height = around + height_of(boxes(table_.heads, head_letters));
    for (const auto& cells : table_.rows) {
      height += height_of(boxes(cells, cell_letters));
      if (height > short_table) return room_for_some_rows;
    }
    return height;
  }

  void write() {
    const std::vector<TextBox> heads = boxes(table_.heads, head_letters);
    column_.keep_together(kept_together());
    if (!table_.title.empty()) {
      column_.go_down(4);
      column_.text(table_.title, table_title_letters);
      column_.go_down(3);
    }
    write_heads(heads);
    for (std::size_t i = 0; i < table_.rows.size(); ++i) {
      const std::vector<TextBox> row = boxes(table_.rows[i], cell_letters);
      double needed = height_of(row);
      if (i + 2 == table_.rows.size()) needed += height_of(boxes(table_.rows[i + 1], cell_letters));
      if (column_.keep_together(needed)) write_heads(heads);  // the last row is not alone on its page
      write_row(row, false);
      column_.rule(PdfColumn::left, length_, 0.4, hairline_colour);
    }
    column_.go_down(11);
  }

 private:
  ColumnNeed need_of(std::size_t number) const {
    ColumnNeed need;
    const auto take = [&](const std::string& text, const Lettering& lettering) {
      need.natural = std::max(need.natural, TextBox(column_.context(), text, lettering).width());
      for (std::size_t from = 0; from <= text.size();) {
        const std::size_t to = std::min(text.find(' ', from), text.size());
        need.least = std::max(need.least, TextBox(column_.context(), text.substr(from, to - from), lettering).width());
        from = to + 1;
      }
    };
    take(table_.heads[number], head_letters);
    for (const auto& cells : table_.rows) take(cells[number], cell_letters);
    if (table_.alignment[number] == 'r')  // numbers are not broken into lines, only their heads are
      for (const auto& cells : table_.rows)
        need.least = std::max(need.least, TextBox(column_.context(), cells[number], cell_letters).width());
    const double slack = 0.5;  // a line that is just as long as the column must not be broken
    return {need.least + slack, need.natural + slack};
  }

  std::vector<TextBox> boxes(const std::vector<std::string>& cells, const Lettering& lettering) const {
    std::vector<TextBox> row;
    for (std::size_t i = 0; i < cells.size(); ++i)
      row.emplace_back(column_.context(), cells[i], lettering, widths_[i], table_.alignment[i] == 'r');
    return row;
  }

  static double height_of(const std::vector<TextBox>& row) {
    double height = 0;
    for (const TextBox& cell : row) height = std::max(height, cell.height());
    return height + 2 * cell_padding;
  }

  void write_heads(const std::vector<TextBox>& heads) {
    write_row(heads, true);
    column_.rule(PdfColumn::left, length_, 0.9, ink);
  }

  /// `low`: cells stand on the row's foot.
  void write_row(const std::vector<TextBox>& row, bool low) {
    const double height = height_of(row);
    double left = PdfColumn::left;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double down = low ? height - 2 * cell_padding - row[i].height() : 0;
      row[i].paint(left, column_.top() + cell_padding + down);
      left += widths_[i] + column_gap;
    }
    column_.go_down(height);
  }

  PdfColumn& column_;
  const Table& table_;
  std::vector<double> widths_;
  double length_ = 0;
};

void write(PdfColumn& column, const Table& table) { TableWriter(column, table).write(); }

/// What a figure takes of the column, without its caption.
double figure_height(double width, double height) { return PdfColumn::width / width * height; }

/// Puts `paint`, which draws in the unit of a picture of that size, into the column, with the caption below it.
void write_figure(PdfColumn& column, double width, double height, const std::string& caption, auto paint) {
  constexpr double gap = 4;
  const TextBox words(column.context(), caption, note_letters, PdfColumn::width);
  const double below = caption.empty() ? 0 : words.height();
  column.keep_together(figure_height(width, height) + gap + below);
  cairo_t* context = &column.context();
  cairo_save(context);
  cairo_translate(context, PdfColumn::left, column.top());
  cairo_scale(context, PdfColumn::width / width, PdfColumn::width / width);
  paint(*context);
  cairo_restore(context);
  column.go_down(figure_height(width, height) + gap);
  if (!caption.empty()) words.paint(PdfColumn::left, column.top());
  column.go_down(below + 9);
}

void write(PdfColumn& column, const Picture& picture) {
  const Image& image = picture.image;
  write_figure(column, image.width, image.height, picture.caption, [&](cairo_t& context) {
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
      auto* row =
          reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(surface) +
                                           static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface));
      for (int x = 0; x < image.width; ++x) {
        const Rgb colour = image.at(x, y);
        row[x] = static_cast<std::uint32_t>(colour.red << 16 | colour.green << 8 | colour.blue);
      }
    }
    cairo_surface_mark_dirty(surface);
    cairo_set_source_surface(&context, surface, 0, 0);
    cairo_paint(&context);
    cairo_surface_destroy(surface);
  });
}

void write(PdfColumn& column, const Chart& chart) {
  write_figure(column, chart.width, chart.height, chart.caption, [&](cairo_t& context) {
    CairoPainter painter(context, chart.height);
    chart.painting(painter, chart.width, chart.height);
  });
}

/// How much of a part must stand on the page of the heading above it.
struct Beginning {
  PdfColumn& column;
  double operator()(const Paragraph&) const { return 20; }
  double operator()(const Facts&) const { return 30; }
  double operator()(const Table& table) const { return TableWriter(column, table).kept_together(); }
  double operator()(const Picture& picture) const {
    return figure_height(picture.image.width, picture.image.height) + 16;
  }
  double operator()(const Chart& chart) const { return figure_height(chart.width, chart.height) + 16; }
};

/// A heading does not stand alone with words above the figure that they lead to.
double height_of_beginning(PdfColumn& column, const Section& section) {
  constexpr double heading = 48;
  double height = heading;
  for (const Part& part : section.parts) {
    height += std::visit(Beginning{column}, part);
    if (!std::holds_alternative<Paragraph>(part)) break;
  }
  return height;
}

void write(PdfColumn& column, const Section& section) {
  column.go_down(12);
  column.keep_together(height_of_beginning(column, section));
  column.rule(PdfColumn::left, PdfColumn::width, 0.6, hairline_colour);
  column.go_down(9);
  column.text(section.title, heading_letters);
  column.go_down(6);
  for (const Part& part : section.parts) std::visit([&](const auto& one) { write(column, one); }, part);
}

}  // namespace

std::string pdf_of(const Document& document) {
  PdfColumn column(document.title);
  column.text(document.title, title_letters);
  column.go_down(4);
  for (const std::string& line : document.below_title) column.text(line, note_letters);
  for (const Section& section : document.sections) write(column, section);
  return column.file();
}

}  // namespace talus::report
