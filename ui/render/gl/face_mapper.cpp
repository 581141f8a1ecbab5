#include <GL/glew.h>  // before any other GL header

#include "render/gl/face_mapper.hpp"

#include <vtkObjectFactory.h>

namespace talus {

vtkStandardNewMacro(FaceMapper)

    void FaceMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
  constexpr float pixels = 1.5;  // a line reaches one to each side; OpenGL measures along an axis
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(pixels, 0);
  Superclass::RenderPieceDraw(renderer, actor);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace talus
