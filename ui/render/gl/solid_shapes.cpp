#include "render/gl/solid_shapes.hpp"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace talus {

namespace {

constexpr int sides = 16, rings = 8;
constexpr double in_front_of_everything = -4e6;  // in steps of a 24-bit depth buffer: a quarter of its range
constexpr double behind_signs = -3e6;            // where rims are: no sign is cut by the rim of another

void put_in_front(vtkActor& actor, double steps) {
  actor.GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, steps);
}

}  // namespace

SolidMesh::SolidMesh() {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh_);
  actor_->SetMapper(mapper);
  actor_->VisibilityOff();
}

void SolidMesh::clear() {
  places_.clear();
  normals_.clear();
  colours_.clear();
  triangles_.clear();
}

int SolidMesh::add_point(const Vec3& place, const Vec3& normal, Rgb colour) {
  places_.push_back(place);
  normals_.push_back(normal);
  colours_.push_back(colour);
  return static_cast<int>(places_.size()) - 1;
}

void SolidMesh::add_cap(const Vec3& centre, const Vec3& from, const Vec3& to, const Vec3& normal, Rgb colour) {
  const int middle = add_point(centre, normal, colour), first = add_point(centre + from, normal, colour);
  triangles_.push_back({middle, first, add_point(centre + to, normal, colour)});
}

void SolidMesh::add_bar(const Vec3& start, const Vec3& end, double start_radius, double end_radius, Rgb colour) {
  const Vec3 axis = (end - start).normalized(), x = axis.unitOrthogonal(), y = axis.cross(x);
  const double slope = (start_radius - end_radius) / (end - start).norm();
  for (int i = 0; i < sides; ++i) {
    const auto around = [&](int k) {
      const double angle = 2 * std::numbers::pi * k / sides;
      return Vec3(std::cos(angle) * x + std::sin(angle) * y);
    };
    const Vec3 a = around(i), b = around(i + 1);
    const Vec3 na = (a + slope * axis).normalized(), nb = (b + slope * axis).normalized();
    const int p = add_point(start + start_radius * a, na, colour), q = add_point(start + start_radius * b, nb, colour);
    const int r = add_point(end + end_radius * b, nb, colour), s = add_point(end + end_radius * a, na, colour);
    triangles_.push_back({p, q, r});
    triangles_.push_back({p, r, s});
    add_cap(start, start_radius * b, start_radius * a, -axis, colour);
    add_cap(end, end_radius * a, end_radius * b, axis, colour);
  }
}

void SolidMesh::add_ball(const Vec3& centre, double radius, Rgb colour) {
  const int first = static_cast<int>(places_.size());
  for (int ring = 0; ring <= rings; ++ring)
    for (int i = 0; i < sides; ++i) {
      const double polar = std::numbers::pi * ring / rings, angle = 2 * std::numbers::pi * i / sides;
      const Vec3 normal(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar));
      add_point(centre + radius * normal, normal, colour);
    }
  for (int ring = 0; ring < rings; ++ring)
    for (int i = 0; i < sides; ++i) {
      const int a = first + ring * sides + i, b = first + ring * sides + (i + 1) % sides;
      triangles_.push_back({a, a + sides, b + sides});
      triangles_.push_back({a, b + sides, b});
    }
}

void SolidMesh::finish() {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkUnsignedCharArray> colours;
  normals->SetNumberOfComponents(3);
  colours->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    points->InsertNextPoint(places_[i].data());
    normals->InsertNextTuple(normals_[i].data());
    const unsigned char tuple[] = {colours_[i].red, colours_[i].green, colours_[i].blue};
    colours->InsertNextTypedTuple(tuple);
  }
  for (const auto& [a, b, c] : triangles_) {
    const vtkIdType triangle[] = {a, b, c};
    cells->InsertNextCell(3, triangle);
  }
  mesh_->SetPoints(points);
  mesh_->SetPolys(cells);
  mesh_->GetPointData()->SetNormals(normals);
  mesh_->GetPointData()->SetScalars(colours);
  actor_->SetVisibility(!triangles_.empty());
}

SolidShapes::SolidShapes() {
  put_in_front(shapes_.actor(), in_front_of_everything);
  shapes_.actor().GetProperty()->SetInterpolationToPhong();
  shapes_.actor().GetProperty()->SetAmbient(0.7);
  shapes_.actor().GetProperty()->SetDiffuse(0.4);
  put_in_front(rims_.actor(), behind_signs);
  rims_.actor().GetProperty()->LightingOff();
  rims_.actor().GetProperty()->FrontfaceCullingOn();
}

/// Signs first: what both move to the very front of the depth buffer stays as it was drawn first.
void SolidShapes::add_to(vtkRenderer& renderer) {
  renderer.AddActor(&shapes_.actor());
  renderer.AddActor(&rims_.actor());
}

void SolidShapes::clear(double rim, Rgb rim_colour) {
  shapes_.clear();
  rims_.clear();
  rim_ = rim;
  rim_colour_ = rim_colour;
}

void SolidShapes::add_bar(const Vec3& start, const Vec3& end, double start_radius, double end_radius, Rgb colour) {
  shapes_.add_bar(start, end, start_radius, end_radius, colour);
  const Vec3 along = (end - start).normalized();
  // The side moves out by the rim; the ends move along it, so that a cone goes on to grow, or to shrink.
  const double slope = (start_radius - end_radius) / (end - start).norm(), out = std::hypot(1, slope);
  rims_.add_bar(start - rim_ * along, end + rim_ * along, start_radius + rim_ * (out + slope),
                end_radius + rim_ * (out - slope), rim_colour_);
}

void SolidShapes::add_ball(const Vec3& centre, double radius, Rgb colour) {
  shapes_.add_ball(centre, radius, colour);
  rims_.add_ball(centre, radius + rim_, rim_colour_);
}

void SolidShapes::finish() {
  shapes_.finish();
  rims_.finish();
}

}  // namespace talus
