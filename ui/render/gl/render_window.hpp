#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

#include "render/gl/gl_context.hpp"

namespace talus {

/// The one kind of VTK window in Talus: off-screen and in Qt alike. It draws into frame buffers of its own with
/// whatever GlContext it is given. A stock vtkRenderWindow needs an X server and ends the process where there is none.
class RenderWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static RenderWindow* New();
  // clang-format off
  vtkTypeMacro(RenderWindow, vtkGenericOpenGLRenderWindow)
      // clang-format on

      /// Makes `context` current and sets the window up for it. `context` must outlive the window or
      /// `release_context()`.
      void set_context(GlContext& context);
  /// Frees every GL object and forgets the context; `set_context` may follow with another one (a re-parented widget).
  void release_context();

  void MakeCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void OpenGLInitContext() override;

 protected:
  RenderWindow();
  ~RenderWindow() override;

 private:
  GlContext* context_ = nullptr;
};

}  // namespace talus
