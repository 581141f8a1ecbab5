#include "render/scene/backdrop.hpp"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>

namespace talus {

Backdrop::Backdrop() {
  vtkNew<vtkPoints> corners;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) corners->InsertNextPoint(x, y, 0);
  colours_->SetNumberOfComponents(3);
  colours_->SetNumberOfTuples(4);
  vtkNew<vtkCellArray> square;
  square->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkPolyData> plane;
  plane->SetPoints(corners);
  plane->SetPolys(square);
  plane->GetPointData()->SetScalars(colours_);
  vtkNew<vtkCoordinate> picture;
  picture->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(plane);
  mapper->SetTransformCoordinate(picture);
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetDisplayLocationToBackground();
}

void Backdrop::add_to(vtkRenderer& renderer) { renderer.AddActor2D(actor_); }

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
