#pragma once

#include <functional>
#include <string>

#include "render/paint/pdf_pages.hpp"
#include "report/document.hpp"

using PangoLayout = struct _PangoLayout;

namespace talus::report {

/// How letters look in a PDF.
struct Lettering {
  double size;  ///< points
  Rgb colour;
  FontWeight weight = FontWeight::regular;
};

/// Text that is broken into lines, and how much room it takes [points].
class TextBox {
 public:
  /// `width` 0: on one line. `right`: lines end at the right.
  TextBox(cairo_t& context, const std::string& text, const Lettering& lettering, double width = 0, bool right = false);
  ~TextBox();
  TextBox(TextBox&& other) noexcept;
  TextBox(const TextBox&) = delete;
  TextBox& operator=(const TextBox&) = delete;

  double width() const;
  double height() const;
  /// Paints it with its upper left corner at that place of the page.
  void paint(double left, double top) const;

 private:
  cairo_t& context_;
  PangoLayout* layout_;
  Rgb colour_;
};

/// The column of text of A4 pages, which is filled from top to bottom, page after page [points].
class PdfColumn {
 public:
  explicit PdfColumn(const std::string& title);

  static constexpr double width = 487;
  static constexpr double left = 54;
  cairo_t& context() { return pages_.context(); }
  double top() const { return top_; }
  /// Goes to the next page where less than `height` is left on this one; true where it does.
  bool keep_together(double height);
  void go_down(double by) { top_ += by; }
  void text(const std::string& text, const Lettering& lettering);
  void rule(double from, double length, double thickness, Rgb colour);
  std::string file();

 private:
  void end_page();

  std::string title_;
  PdfPages pages_;
  double top_;
  int page_ = 1;
};

}  // namespace talus::report
