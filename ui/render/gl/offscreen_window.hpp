#pragma once

#include <vtkNew.h>

#include <memory>

#include "render/gl/gl_context.hpp"
#include "render/gl/render_window.hpp"
#include "render/paint/image.hpp"

class vtkRenderer;

namespace talus {

/// A window without a screen: what is drawn comes back as a picture.
class OffscreenWindow {
 public:
  /// `scale`² pixels are drawn for each pixel of the picture and averaged.
  OffscreenWindow(int width, int height, int scale, OffscreenBackend backend = OffscreenBackend::automatic);
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  void add(vtkRenderer& renderer);
  /// Frees what the renderer holds on the graphics side.
  void remove(vtkRenderer& renderer);
  Image draw();

 private:
  int width_, height_, scale_;
  std::unique_ptr<GlContext> context_;
  vtkNew<RenderWindow> window_;
};

}  // namespace talus
