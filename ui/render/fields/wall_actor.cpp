#include "render/fields/wall_actor.hpp"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace talus {

namespace {

constexpr double lift = 0.2;  // pixels: nearer than the face that it lies on, farther than the lines on that

/// The class that most corners are in, or one of them, for all; empty where less than two corners are in one.
std::optional<std::array<double, 3>> class_of(const JointWalls::Triangle& triangle, std::span<const double> values) {
  std::array<double, 3> met;
  std::size_t count = 0;
  for (const int point : triangle.points)
    if (const double value = values[static_cast<std::size_t>(point)]; std::isfinite(value)) met[count++] = value;
  if (count < 2) return {};
  met.fill(met[count - 2] == met[count - 1] ? met[count - 1] : met[0]);
  return met;
}

}  // namespace

WallActor::WallActor(const Vec3& origin) : origin_(origin) {
  mapper_->SetInputData(mesh_);
  mapper_->SetScalarModeToUsePointData();
  mapper_->SetColorModeToDirectScalars();
  actor_->SetMapper(mapper_);
  make_matt(*actor_->GetProperty());
  hide();
}

void WallActor::add_to(vtkRenderer& renderer) { renderer.AddActor(actor_); }

void WallActor::show(const JointWalls& walls, std::span<const Vec3> places, std::span<const double> values,
                     const std::vector<bool>& shown, const Colouring& colouring) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  points->SetDataTypeToDouble();
  colours->SetNumberOfComponents(3);
  for (const JointWalls::Triangle& triangle : walls.triangles) {
    if (!shown[static_cast<std::size_t>(triangle.block)]) continue;
    const auto value = colouring.by_class ? class_of(triangle, values) : corner_values(triangle, values);
    if (!value) continue;
    const double mean = ((*value)[0] + (*value)[1] + (*value)[2]) / 3;
    if (colouring.only && !colouring.by_class && !(mean >= colouring.only->low && mean <= colouring.only->high))
      continue;
    cells->InsertNextCell(3);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 place = places[static_cast<std::size_t>(triangle.points[i])] - origin_;
      cells->InsertCellPoint(points->InsertNextPoint(place.data()));
      const Rgb c = colouring.colour((*value)[i]);
      const unsigned char tuple[] = {c.red, c.green, c.blue};
      colours->InsertNextTypedTuple(tuple);
    }
  }
  mesh_->SetPoints(points);
  mesh_->SetPolys(cells);
  mesh_->GetPointData()->SetScalars(colours);
  actor_->SetVisibility(mesh_->GetNumberOfPolys() > 0);
}

void WallActor::hide() { actor_->VisibilityOff(); }

void WallActor::cut_by(vtkPlane* plane) { clip(*actor_, plane); }

void WallActor::style(const Vec3& pixel) { actor_->SetPosition(Vec3(lift * pixel).data()); }

}  // namespace talus
