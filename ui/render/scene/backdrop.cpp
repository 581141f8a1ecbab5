#include "render/scene/backdrop.hpp"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

namespace talus {

Backdrop::Backdrop() {
  constexpr double far = 1;
  vtkNew<vtkPoints> corners;
  for (const auto& [x, y] : {std::pair{-far, -far}, {far, -far}, {far, far}, {-far, far}})
    corners->InsertNextPoint(x, y, 0);
  colours_->SetNumberOfComponents(3);
  colours_->SetNumberOfTuples(4);
  vtkNew<vtkCellArray> square;
  square->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkPolyData> plane;
  plane->SetPoints(corners);
  plane->SetPolys(square);
  plane->GetPointData()->SetScalars(colours_);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(plane);
  actor_->SetMapper(mapper);
  actor_->GetProperty()->LightingOff();
  actor_->UseBoundsOff();
  vtkShaderProperty& shaders = *actor_->GetShaderProperty();
  shaders.AddVertexShaderReplacement(
      "//VTK::PositionVC::Impl", true,
      "//VTK::PositionVC::Impl\n  gl_Position = vec4(sign(vertexMC.xy), 0.999999, 1.0);  // as far as can be\n", false);
  // Its place for ambient occlusion, m: too far for anything to be darkened there or by it.
  shaders.AddFragmentShaderReplacement("//VTK::Coincident::Impl", true,
                                       "//VTK::Coincident::Impl\n  gl_FragData[1] = vec4(0.0, 0.0, -1e9, 1.0);\n",
                                       false);
}

void Backdrop::add_to(vtkRenderer& renderer) { renderer.AddActor(actor_); }

void Backdrop::style(Rgb top, Rgb bottom) {
  for (int corner = 0; corner < 4; ++corner) {
    const Rgb c = corner < 2 ? bottom : top;
    const unsigned char tuple[] = {c.red, c.green, c.blue};
    colours_->SetTypedTuple(corner, tuple);
  }
  colours_->Modified();
}

void Backdrop::show(bool shown) { actor_->SetVisibility(shown); }

}  // namespace talus
