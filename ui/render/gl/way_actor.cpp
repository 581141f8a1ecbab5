#include "render/gl/way_actor.hpp"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace talus {

WayActor::WayActor() {
  mapper_->SetInputData(lines_);
  mapper_->SetScalarModeToUsePointData();
  mapper_->SetColorModeToDirectScalars();
  constexpr double in_front_of_everything = -4e6;  // in steps of a 24-bit depth buffer: a quarter of its range
  mapper_->SetRelativeCoincidentTopologyLineOffsetParameters(0, in_front_of_everything);
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->SetLighting(false);
  actor_->VisibilityOff();
}

void WayActor::add_to(vtkRenderer& renderer) { renderer.AddActor(actor_); }

void WayActor::show(const std::vector<Way>& ways) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  points->SetDataTypeToDouble();
  colours->SetNumberOfComponents(3);
  for (const Way& way : ways) {
    const unsigned char colour[] = {way.colour.red, way.colour.green, way.colour.blue};
    cells->InsertNextCell(static_cast<int>(way.points.size()));
    for (const Vec3& point : way.points) {
      cells->InsertCellPoint(points->InsertNextPoint(point.data()));
      colours->InsertNextTypedTuple(colour);
    }
  }
  lines_->SetPoints(points);
  lines_->SetLines(cells);
  lines_->GetPointData()->SetScalars(colours);
  actor_->SetVisibility(!ways.empty());
}

void WayActor::style(double width) { LineMapper::style(*actor_, width); }

}  // namespace talus
