#include "render/paint/pdf_pages.hpp"

#include <cairo-pdf.h>

#include "render/paint/cairo_painter.hpp"

namespace talus {

struct PdfPages::Surface {
  std::string file;
  cairo_surface_t* surface = nullptr;
};

PdfPages::PdfPages(double width, double height, const std::string& title) : surface_(std::make_unique<Surface>()) {
  const auto append = [](void* to, const unsigned char* bytes, unsigned count) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
  };
  surface_->surface = cairo_pdf_surface_create_for_stream(append, &surface_->file, width, height);
  cairo_pdf_surface_set_metadata(surface_->surface, CAIRO_PDF_METADATA_TITLE, title.c_str());
  cairo_pdf_surface_set_metadata(surface_->surface, CAIRO_PDF_METADATA_CREATOR, "Talus");
  context_ = cairo_create(surface_->surface);
}

PdfPages::~PdfPages() {
  cairo_destroy(context_);
  cairo_surface_destroy(surface_->surface);
}

void PdfPages::end_page() { cairo_show_page(context_); }

std::string PdfPages::file() {
  cairo_surface_finish(surface_->surface);
  return surface_->file;
}

std::string pdf_of(double width, double height, const std::string& title, std::span<const Painting> paintings) {
  constexpr double points_a_pixel = 0.75;
  PdfPages pages(points_a_pixel * width, points_a_pixel * height, title);
  CairoPainter painter(pages.context(), height);
  for (const Painting& painting : paintings) {
    cairo_save(&pages.context());
    cairo_scale(&pages.context(), points_a_pixel, points_a_pixel);
    painting(painter, width, height);
    cairo_restore(&pages.context());
    pages.end_page();
  }
  return pages.file();
}

}  // namespace talus
