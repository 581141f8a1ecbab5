#include "render/scene/joint_actors.hpp"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

namespace talus {
namespace {

constexpr unsigned char faint = 84, strong = 150, outline = 140, chosen_outline = 255;  // opacities of 255

/// Cells with corners of their own.
struct CornerCells {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;

  CornerCells() { points->SetDataTypeToDouble(); }
  void add(std::span<const Vec3> corners, const Vec3& origin) {
    cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const Vec3& corner : corners) {
      const Vec3 p = corner - origin;
      cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
  }
};

void add_colour(vtkUnsignedCharArray& colours, std::size_t corners, Rgb colour, unsigned char opacity) {
  const unsigned char tuple[] = {colour.red, colour.green, colour.blue, opacity};
  for (std::size_t i = 0; i < corners; ++i) colours.InsertNextTypedTuple(tuple);
}

void make_flat(vtkPolyData& data, vtkActor& actor, vtkPolyDataMapper& mapper) {
  mapper.SetInputData(&data);
  mapper.SetScalarModeToUsePointData();
  mapper.SetColorModeToDirectScalars();
  actor.SetMapper(&mapper);
  actor.GetProperty()->SetLighting(false);
  actor.ForceTranslucentOn();
}

/// How far along the line a triangle is met; infinite where it is not. Möller and Trumbore (1997).
double distance_to(const FlatTriangle& triangle, const Vec3& from, const Vec3& along) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const Vec3 ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0], p = along.cross(ac);
  const double determinant = ab.dot(p);
  if (determinant == 0) return never;
  const Vec3 from_a = from - triangle[0], q = from_a.cross(ab);
  const double u = from_a.dot(p) / determinant, v = along.dot(q) / determinant, distance = ac.dot(q) / determinant;
  return u < 0 || v < 0 || u + v > 1 || distance < 0 ? never : distance;
}

}  // namespace

JointActors::JointActors(const Vec3& origin) : origin_(origin) {
  vtkNew<vtkPolyDataMapper> face_mapper, line_mapper;
  make_flat(*mesh_, *face_actor_, *face_mapper);
  make_flat(*lines_, *line_actor_, *line_mapper);
}

void JointActors::add_to(vtkRenderer& renderer) {
  renderer.AddActor(face_actor_);
  renderer.AddActor(line_actor_);
}

bool JointActors::show(std::shared_ptr<const std::vector<JointFace>> faces, std::vector<int> chosen) {
  if (faces == faces_ && chosen == chosen_) return false;
  const bool are_others = faces != faces_;
  faces_ = std::move(faces);
  chosen_ = std::move(chosen);
  if (are_others) draw();
  colour();
  return true;
}

void JointActors::use(Theme theme) {
  if (theme == theme_) return;
  theme_ = theme;
  colour();
}

std::span<const JointFace> JointActors::shown() const {
  return faces_ ? std::span<const JointFace>(*faces_) : std::span<const JointFace>();
}

void JointActors::draw() {
  CornerCells areas, edges;
  for (const JointFace& face : shown()) {
    for (const FlatTriangle& triangle : face.triangles) areas.add(triangle, origin_);
    for (const Edge& edge : face.outline) edges.add(edge, origin_);
  }
  mesh_->SetPoints(areas.points);
  mesh_->SetPolys(areas.cells);
  lines_->SetPoints(edges.points);
  lines_->SetLines(edges.cells);
  face_actor_->SetVisibility(mesh_->GetNumberOfPolys() > 0);
  line_actor_->SetVisibility(lines_->GetNumberOfLines() > 0);
}

/// By corners: colours of cells cost more to draw.
void JointActors::colour() {
  vtkNew<vtkUnsignedCharArray> of_areas, of_edges;
  for (vtkUnsignedCharArray* colours : {of_areas.Get(), of_edges.Get()}) colours->SetNumberOfComponents(4);
  const auto& palette = curve_palette(theme_);
  for (const JointFace& face : shown()) {
    const Rgb colour = palette[static_cast<std::size_t>(face.set) % palette.size()];
    const bool is_chosen = std::ranges::count(chosen_, face.cut) > 0;
    add_colour(*of_areas, 3 * face.triangles.size(), colour, is_chosen ? strong : faint);
    add_colour(*of_edges, 2 * face.outline.size(), is_chosen ? colours(theme_).pick : colour,
               is_chosen ? chosen_outline : outline);
  }
  mesh_->GetPointData()->SetScalars(of_areas);
  lines_->GetPointData()->SetScalars(of_edges);
}

void JointActors::style(double line_width) { line_actor_->GetProperty()->SetLineWidth(static_cast<float>(line_width)); }

std::optional<int> JointActors::cut_at(const Vec3& from, const Vec3& along) const {
  std::optional<int> found;
  double nearest = std::numeric_limits<double>::infinity();
  for (const JointFace& face : shown())
    for (const FlatTriangle& triangle : face.triangles) {
      const double distance = distance_to(triangle, from, along);
      if (distance >= nearest) continue;
      nearest = distance;
      found = face.cut;
    }
  return found;
}

}  // namespace talus
