#include <GL/glew.h>  // before any other GL header

#include "render/gl/render_window.hpp"

#include <vtkObjectFactory.h>

namespace talus {

vtkStandardNewMacro(RenderWindow)

    RenderWindow::RenderWindow() {
  SetReadyForRendering(false);
  SetFrameBlitModeToNoBlit();  // pictures are read, and blitted, from VTK's own frame buffer
  SetShowWindow(false);
  SetMapped(1);
  SetMultiSamples(0);  // depth peeling and ambient occlusion do not go together with multisampling
  SetDPI(72);          // a point is a pixel: font sizes are given in pixels
}

RenderWindow::~RenderWindow() {
  release_context();  // while MakeCurrent is still ours
}

void RenderWindow::set_context(GlContext& context) {
  context_ = &context;
  context_->make_current();
  SetForceMaximumHardwareLineWidth(1);  // wide lines by VTK's geometry shader: the same on every driver
  SetOwnContext(0);
  SetReadyForRendering(true);
  OpenGLInitContext();
}

void RenderWindow::release_context() {
  if (context_ == nullptr) return;
  context_->make_current();
  Finalize();
  SetReadyForRendering(false);
  context_ = nullptr;
  Initialized = false;
}

void RenderWindow::MakeCurrent() {
  if (context_ != nullptr) context_->make_current();
}

bool RenderWindow::IsCurrent() { return context_ != nullptr && context_->is_current(); }

void RenderWindow::OpenGLInitContext() {
  if (!Initialized) {
    // Debian's GLEW is built for GLX: it loads every entry point first and only then asks GLX for a display. That
    // last step fails without X and does not matter here, but VTK would give up on it.
    const GLenum outcome = glewInit();
    if (outcome != GLEW_OK && outcome != GLEW_ERROR_NO_GLX_DISPLAY) {
      vtkErrorMacro("OpenGL cannot be loaded: " << glewGetErrorString(outcome));
      return;
    }
    if (!GLEW_VERSION_3_2) {
      vtkErrorMacro("OpenGL 3.2 is needed");
      return;
    }
    GlewInitValid = true;
    Initialized = true;
    GLfloat range[2] = {1, 1};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
    MaximumHardwareLineWidth = range[1];
  }
  Superclass::OpenGLInitContext();
}

}  // namespace talus
