#pragma once

#include <vtkOpenGLPolyDataMapper.h>

class vtkActor;

namespace talus {

/// Draws lines with smooth sides, of any width: a pixel takes as much of a line's colour as the line covers of it.
/// Drawn all or nothing, a thin line is one pixel wide here and two there, and looks dashed where it runs askew. What
/// is opaque behind lines is to be drawn before them.
class LineMapper : public vtkOpenGLPolyDataMapper {
 public:
  static LineMapper* New();
  // clang-format off
  vtkTypeMacro(LineMapper, vtkOpenGLPolyDataMapper)
      // clang-format on

      /// Pixels, and how much of what is behind a line it covers, 0 to 1. A line that is thinner than a pixel is drawn
      /// as wide as one, and paler.
      static void style(vtkActor& lines, double width, double opacity = 1);

  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

 protected:
  bool GetNeedToRebuildShaders(vtkOpenGLHelper& cells, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                           vtkActor* actor) override;

 private:
  bool built_among_seen_through_ = false;  ///< as the shaders stand
};

}  // namespace talus
