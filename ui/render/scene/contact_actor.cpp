#include "render/scene/contact_actor.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "render/fields/field_classes.hpp"

namespace talus {

ContactActor::ContactActor() {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(points_);
  constexpr double in_front_of_everything = -4e6;  // in steps of a 24-bit depth buffer: a quarter of its range
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(in_front_of_everything);
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetRenderPointsAsSpheres(true);
}

void ContactActor::add_to(vtkRenderer& renderer) { renderer.AddActor(actor_); }

void ContactActor::show(std::span<const ContactSample> contacts, std::span<const Vec3> places, const Vec3& origin,
                        double size_in_pixels) {
  vtkNew<vtkPoints> dots_at;
  vtkNew<vtkCellArray> dots;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Vec3 p = places[i] - origin;
    const vtkIdType id = dots_at->InsertNextPoint(p.data());
    dots->InsertNextCell(1, &id);
    const Rgb c = state_colour(contacts[i].state);
    const unsigned char tuple[] = {c.red, c.green, c.blue};
    colours->InsertNextTypedTuple(tuple);
  }
  points_->SetPoints(dots_at);
  points_->SetVerts(dots);
  points_->GetPointData()->SetScalars(colours);
  actor_->GetProperty()->SetPointSize(static_cast<float>(size_in_pixels));
  actor_->SetVisibility(!contacts.empty());
}

}  // namespace talus
