#pragma once

#include <vtkOpenGLPolyDataMapper.h>

class vtkActor;
class vtkPlane;
class vtkProperty;

namespace talus {

/// Rock breaks along planes: its faces are flat and matt. Normals then need no upkeep while it moves.
void make_matt(vtkProperty& property);

/// Only what lies on the side of the plane's normal is drawn; null: all of it.
void clip(vtkActor& actor, vtkPlane* plane);

/// Draws faces as if they lay a little farther from the viewer, so that lines on them are seen whole. Beside the middle
/// of a line, a face that is seen at a flat angle is nearer to the viewer than the line by many pixels, one that is
/// seen from the front by none: each face goes back by what its depth changes over one pixel and a half. On the
/// screen nothing moves by more than that.
class FaceMapper : public vtkOpenGLPolyDataMapper {
 public:
  static FaceMapper* New();
  // clang-format off
  vtkTypeMacro(FaceMapper, vtkOpenGLPolyDataMapper)
      // clang-format on

      void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
};

}  // namespace talus
