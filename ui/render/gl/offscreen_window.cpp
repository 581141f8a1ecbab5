#include "render/gl/offscreen_window.hpp"

#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace talus {
namespace {

/// Averages scale² bytes of VTK's bottom-up rows into each byte of a top-down picture.
Image reduced(const unsigned char* drawn, int width, int height, int scale) {
  Image image(width, height);
  const std::size_t row = static_cast<std::size_t>(width) * scale * 3;
  const int count = scale * scale;
  std::uint8_t* out = image.rgb.data();
  for (int y = 0; y < height; ++y) {
    const unsigned char* top = drawn + row * scale * static_cast<std::size_t>(height - 1 - y);
    if (scale == 1) {
      out = std::copy_n(top, row, out);
      continue;
    }
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        int sum = count / 2;
        for (int j = 0; j < scale; ++j)
          for (int i = 0; i < scale; ++i) sum += top[row * j + 3 * (static_cast<std::size_t>(x) * scale + i) + channel];
        *out++ = static_cast<std::uint8_t>(sum / count);
      }
  }
  return image;
}

}  // namespace

OffscreenWindow::OffscreenWindow(int width, int height, int scale, OffscreenBackend backend)
    : width_(width), height_(height), scale_(scale), context_(make_offscreen_context(backend)) {
  window_->set_context(*context_);
  window_->SetSize(width * scale, height * scale);
}

OffscreenWindow::~OffscreenWindow() {
  window_->release_context();
  context_->done_current();
}

void OffscreenWindow::add(vtkRenderer& renderer) { window_->AddRenderer(&renderer); }

void OffscreenWindow::remove(vtkRenderer& renderer) {
  window_->MakeCurrent();
  renderer.ReleaseGraphicsResources(window_);
  window_->RemoveRenderer(&renderer);
}

Image OffscreenWindow::draw() {
  window_->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  constexpr int back_buffer = 0;
  window_->GetPixelData(0, 0, width_ * scale_ - 1, height_ * scale_ - 1, back_buffer, pixels.Get(), 0);
  return reduced(pixels->GetPointer(0), width_, height_, scale_);
}

}  // namespace talus
