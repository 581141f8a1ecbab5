#include <GL/glew.h>  // before any other GL header

#include "render/gl/line_mapper.hpp"

#include <vtkActor.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>

#include <algorithm>

namespace talus {
namespace {

bool among_seen_through(vtkRenderer& renderer) { return renderer.GetUseDepthPeeling() != 0; }

}  // namespace

vtkStandardNewMacro(LineMapper)

    void LineMapper::style(vtkActor& lines, double width, double opacity) {
  constexpr double sides = 1;  // pixels: half of one on each side, of which the line covers a part
  lines.GetProperty()->SetLineWidth(static_cast<float>(std::max(1.0, width) + sides));
  lines.GetProperty()->SetOpacity(opacity * std::min(1.0, width));
  lines.ForceOpaqueOn();
}

/// Among what is opaque, blended, and without their depth, for the pale sides of one would hide another that it meets.
/// What is seen through is drawn after them and has to know which of it is before them: they have a depth then, and no
/// pale sides, which would hide what is behind.
void LineMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
  auto& state = *static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  const vtkOpenGLState::ScopedglEnableDisable with_blending(&state, GL_BLEND);
  const vtkOpenGLState::ScopedglDepthMask with_depth(&state);
  state.vtkglEnable(GL_BLEND);
  state.vtkglDepthMask(among_seen_through(*renderer) ? GL_TRUE : GL_FALSE);
  Superclass::RenderPieceDraw(renderer, actor);
}

bool LineMapper::GetNeedToRebuildShaders(vtkOpenGLHelper& cells, vtkRenderer* renderer, vtkActor* actor) {
  const bool fits = built_among_seen_through_ == among_seen_through(*renderer);
  return Superclass::GetNeedToRebuildShaders(cells, renderer, actor) || !fits;
}

/// VTK widens a line to a strip of four corners. `across` is −1 on its one side and 1 on the other, so that it changes
/// by 2 over the strip, whose outermost pixel on either side is the one that is covered in part.
void LineMapper::ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                                     vtkActor* actor) {
  const auto replace = [&](vtkShader::Type type, const char* what, const char* by) {
    std::string source = shaders[type]->GetSource();
    vtkShaderProgram::Substitute(source, what, by);
    shaders[type]->SetSource(source);
  };
  replace(vtkShader::Geometry, "uniform vec2 lineWidthNVC;", "uniform vec2 lineWidthNVC;\nout float across;");
  // VTK takes a right angle in units of the picture's sides, which is one on the screen for square pictures alone.
  replace(vtkShader::Geometry, "normal = vec2(-1.0*normal.y,normal.x);",
          "normal = normalize(normal / lineWidthNVC);\n  normal = vec2(-normal.y, normal.x);");
  replace(vtkShader::Geometry, "EmitVertex();", "across = 2.0*((j+1)%2) - 1.0;\n    EmitVertex();");
  replace(vtkShader::Fragment, "//VTK::Coincident::Dec", "//VTK::Coincident::Dec\nin float across;");
  replace(vtkShader::Fragment, "//VTK::UniformFlow::Impl",
          "//VTK::UniformFlow::Impl\n  float acrossPixel = length(vec2(dFdx(across), dFdy(across)));");
  built_among_seen_through_ = among_seen_through(*renderer);
  replace(vtkShader::Fragment, "//VTK::Light::Impl",
          built_among_seen_through_
              ? "//VTK::Light::Impl\n  if (1.0 - abs(across) < 0.5 * acrossPixel) discard;"
              : "//VTK::Light::Impl\n  gl_FragData[0].a *= clamp((1.0 - abs(across)) / acrossPixel, 0.0, 1.0);");
  Superclass::ReplaceShaderValues(shaders, renderer, actor);
}

}  // namespace talus
