#pragma once

#include <memory>
#include <span>
#include <string>

#include "render/paint/painter.hpp"

using cairo_t = struct _cairo;

namespace talus {

/// A PDF that grows page by page, in memory.
class PdfPages {
 public:
  /// Of a page, in points.
  PdfPages(double width, double height, const std::string& title);
  ~PdfPages();
  PdfPages(const PdfPages&) = delete;
  PdfPages& operator=(const PdfPages&) = delete;

  /// Of the page that is drawn now: points, from its upper left corner.
  cairo_t& context() { return *context_; }
  void end_page();
  /// The whole file; ends it.
  std::string file();

 private:
  struct Surface;
  std::unique_ptr<Surface> surface_;
  cairo_t* context_;
};

/// The file of a PDF with a page for each painting, of `width` × `height` pixels, 96 to the inch.
std::string pdf_of(double width, double height, const std::string& title, std::span<const Painting> paintings);

}  // namespace talus
