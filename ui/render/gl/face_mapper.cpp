#include <GL/glew.h>  // before any other GL header

#include "render/gl/face_mapper.hpp"

#include <vtkActor.h>
#include <vtkObjectFactory.h>
#include <vtkPlane.h>
#include <vtkProperty.h>

namespace talus {

void make_matt(vtkProperty& property) {
  property.SetInterpolationToFlat();
  property.SetAmbient(0.36);
  property.SetDiffuse(0.74);
  property.SetSpecular(0);
}

void clip(vtkActor& actor, vtkPlane* plane) {
  actor.GetMapper()->RemoveAllClippingPlanes();
  if (plane) actor.GetMapper()->AddClippingPlane(plane);
}

vtkStandardNewMacro(FaceMapper)

    void FaceMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
  constexpr float pixels = 1.5;  // a line reaches one to each side; OpenGL measures along an axis
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(pixels, 0);
  Superclass::RenderPieceDraw(renderer, actor);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace talus
