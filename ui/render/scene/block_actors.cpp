#include "render/scene/block_actors.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkLookupTable.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <utility>

#include "render/gl/line_mapper.hpp"

namespace talus {
namespace {

void set_colour(vtkProperty& property, Rgb colour) {
  property.SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

/// Makes the cells those of `corners` vertices each which follow one another.
void set_cells(vtkCellArray& cells, int corners, std::span<const int> vertices) {
  vtkNew<vtkTypeInt32Array> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(vertices.size()));
  std::ranges::copy(vertices, connectivity->GetPointer(0));
  cells.SetData(corners, connectivity);
}

void set_points(vtkPoints& points, std::span<const Vec3> positions, const Vec3& origin) {
  points.SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 p = positions[i] - origin;
    points.SetPoint(static_cast<vtkIdType>(i), p.data());
  }
  points.Modified();
}

/// For each block, from the origin to the mean of its vertices, m; zero where it has none.
std::vector<Vec3> ways_to_blocks(const BlockSurface& surface, const Vec3& origin) {
  std::vector<Vec3> ways;
  for (std::size_t block = 0; block + 1 < surface.begins.size(); ++block) {
    Vec3 sum = Vec3::Zero();
    const int begin = surface.begins[block].vertex, end = surface.begins[block + 1].vertex;
    for (int i = begin; i < end; ++i) sum += surface.rest[static_cast<std::size_t>(i)] - origin;
    ways.push_back(begin < end ? Vec3(sum / (end - begin)) : sum);
  }
  return ways;
}

double area_of(const BlockSurface& surface) {
  const auto at = [&](int vertex) -> const Vec3& { return surface.rest[static_cast<std::size_t>(vertex)]; };
  double area = 0;
  for (const BlockSurface::Triangle& triangle : surface.triangles) {
    const auto& [a, b, c] = triangle.vertices;
    area += (at(b) - at(a)).cross(at(c) - at(a)).norm() / 2;
  }
  return area;
}

/// Opacity of lines that are so many pixels apart. What they cover of the rock is their width over their spacing: near
/// to each other they fade faster than they grow dense, and small facets show the rock, not the lines around them.
double strength_of_lines(double spacing) {
  constexpr double apart = 3.5;  // pixels; triangles of three times as much a side
  const double fraction = std::min(1.0, spacing / apart);
  return fraction * fraction;
}

/// Lines are drawn as if nearer by some `pixels` than the faces that they lie on, or than other lines: that shows none
/// through the rock, however near or far it is. What faces at a flat angle need beside it is in FaceMapper.
void bring_nearer(vtkActor& lines, double pixels, const Vec3& pixel) {
  const Vec3 by = pixels * pixel;
  lines.SetPosition(by.x(), by.y(), by.z());
}

void add_lines(vtkRenderer& renderer, vtkPolyData& lines, vtkActor& actor) {
  vtkNew<LineMapper> mapper;
  mapper->SetInputData(&lines);
  mapper->ScalarVisibilityOff();
  constexpr double not_in_steps_of_depth = 4;  // which can be metres: takes back what VTK gives all lines
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, not_in_steps_of_depth);
  actor.SetMapper(mapper);
  actor.GetProperty()->SetLighting(false);
  renderer.AddActor(&actor);
}

constexpr double lift_of_mesh = 0.4, lift_of_edges = 0.7, lift_of_marks = 1;  // pixels

}  // namespace

BlockActors::BlockActors(BlockSurface surface, const Vec3& origin)
    : surface_(std::move(surface)),
      origin_(origin),
      from_origin_(ways_to_blocks(surface_, origin)),
      positions_(surface_.rest),
      area_(area_of(surface_)),
      spacing_of_edges_(spacing(true, 0)) {
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  points_->SetDataTypeToDouble();
  for (vtkPolyData* data : {faces_.Get(), thinned_faces_.Get(), sharp_edges_.Get(), mesh_lines_.Get()})
    data->SetPoints(points_);
  set_points(*points_, positions_, origin_);
  mapper_->SetInputData(faces_);
  mapper_->SetInterpolateScalarsBeforeMapping(true);
  face_actor_->SetMapper(mapper_);
  make_matt(*face_actor_->GetProperty());
  show(std::vector<bool>(from_origin_.size(), true));
  show_mesh_lines(0);
  if (!surface_.edges.empty())
    shortest_ =
        std::ranges::min(surface_.edges | std::views::transform([this](const auto& edge) { return length(edge); }));
}

void BlockActors::add_faces_to(vtkRenderer& renderer) { renderer.AddActor(face_actor_); }

void BlockActors::add_lines_to(vtkRenderer& renderer) {
  add_lines(renderer, *mesh_lines_, *mesh_actor_);
  add_lines(renderer, *sharp_edges_, *sharp_edge_actor_);
}

void BlockActors::move(std::span<const Vec3> displacement, double scale, double explosion) {
  for (std::size_t block = 0; block < from_origin_.size(); ++block) {
    const Vec3 apart = explosion * from_origin_[block];
    const int end = surface_.begins[block + 1].vertex;
    for (int i = surface_.begins[block].vertex; i < end; ++i) {
      positions_[i] = surface_.rest[i] + apart;
      if (!displacement.empty()) positions_[i] += scale * displacement[surface_.nodes[i]];
    }
  }
  set_points(*points_, positions_, origin_);
}

void BlockActors::show(std::vector<bool> shown) {
  shown_ = std::move(shown);
  drawn_.clear();
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
    if (shows(surface_.triangles[t].block)) drawn_.push_back(static_cast<int>(t));
  all_kept_ = false;
  keep({});
  fill_thinned();
  fill_edges(*sharp_edges_, true, 0);
  mesh_lines_from_.reset();
}

void BlockActors::keep(const std::function<bool(int)>& kept) {
  if (all_kept_ && !kept) return;
  all_kept_ = !kept;
  cells_.clear();
  std::vector<int> vertices;
  for (const int t : drawn_) {
    if (kept && !kept(t)) continue;
    const auto& corners = surface_.triangles[static_cast<std::size_t>(t)].vertices;
    vertices.insert(vertices.end(), corners.begin(), corners.end());
    cells_.push_back(t);
  }
  vtkNew<vtkCellArray> polygons;
  set_cells(*polygons, 3, vertices);
  faces_->SetPolys(polygons);
  faces_->GetCellData()->SetScalars(nullptr);  // belonged to the former cells; colouring follows
}

/// They are many, and drawn on few occasions. The length goes in steps, or a camera that moves would ask for others
/// with every picture.
void BlockActors::show_mesh_lines(double least) {
  const double from = least <= shortest_ ? 0 : std::exp2(std::floor(2 * std::log2(least)) / 2);
  if (mesh_lines_from_ == from) return;
  mesh_lines_from_ = from;
  spacing_of_mesh_ = spacing(false, from);
  fill_edges(*mesh_lines_, false, from);
}

double BlockActors::length(const BlockSurface::Edge& edge) const {
  const auto& [from, to] = edge.vertices;
  return (surface_.rest[static_cast<std::size_t>(from)] - surface_.rest[static_cast<std::size_t>(to)]).norm();
}

double BlockActors::spacing(bool sharp, double least) const {
  double sum = 0;
  for (const BlockSurface::Edge& edge : surface_.edges)
    if (const double one = length(edge); edge.sharp == sharp && one >= least) sum += one;
  return sum > 0 ? area_ / sum : std::numeric_limits<double>::infinity();
}

void BlockActors::fill_edges(vtkPolyData& lines, bool sharp, double least) {
  std::vector<int> vertices;
  for (const BlockSurface::Edge& edge : surface_.edges)
    if (edge.sharp == sharp && shows(edge.block) && length(edge) >= least)
      vertices.insert(vertices.end(), edge.vertices.begin(), edge.vertices.end());
  vtkNew<vtkCellArray> cells;
  set_cells(*cells, 2, vertices);
  lines.SetLines(cells);
}

void BlockActors::fill_thinned() {
  std::vector<int> vertices;
  for (const Face& face : thinned_)
    if (shows(face.block)) vertices.insert(vertices.end(), face.vertices.begin(), face.vertices.end());
  vtkNew<vtkCellArray> polygons;
  set_cells(*polygons, 3, vertices);
  thinned_faces_->SetPolys(polygons);
}

void BlockActors::thin(std::vector<Face> faces) {
  thinned_ = std::move(faces);
  fill_thinned();
}

void BlockActors::let_through(double opacity) {
  mapper_->SetInputData(opacity < 1 && !thinned_.empty() ? thinned_faces_ : faces_);
  face_actor_->GetProperty()->SetOpacity(opacity);
  face_actor_->GetProperty()->SetBackfaceCulling(opacity < 1);
}

void BlockActors::cut_by(vtkPlane* plane) {
  for (vtkActor* actor : {face_actor_.Get(), sharp_edge_actor_.Get(), mesh_actor_.Get()}) clip(*actor, plane);
}

/// No vertex is shared by blocks, and colours of vertices cost less to draw than those of cells.
void BlockActors::colour_by_block(const std::function<Rgb(int)>& colour) {
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(surface_.rest.size()));
  for (std::size_t block = 0; block < shown_.size(); ++block) {
    const Rgb c = shown_[block] ? colour(static_cast<int>(block)) : Rgb{};
    const unsigned char tuple[] = {c.red, c.green, c.blue};
    for (int i = surface_.begins[block].vertex; i < surface_.begins[block + 1].vertex; ++i)
      colours->SetTypedTuple(i, tuple);
  }
  for (vtkPolyData* data : {faces_.Get(), thinned_faces_.Get()}) {
    data->GetPointData()->SetScalars(colours);
    data->GetCellData()->SetScalars(nullptr);
  }
  mapper_->SetScalarModeToUsePointData();
  mapper_->SetColorModeToDirectScalars();
}

void BlockActors::colour_by_values(std::span<const double> values, bool at_nodes, vtkLookupTable& table, double low,
                                   double high) {
  vtkNew<vtkDoubleArray> scalars;
  if (at_nodes) {
    for (const int node : surface_.nodes) scalars->InsertNextValue(values[node]);
    faces_->GetPointData()->SetScalars(scalars);
    faces_->GetCellData()->SetScalars(nullptr);
    mapper_->SetScalarModeToUsePointData();
  } else {
    for (const int t : cells_) {
      const int tetrahedron = surface_.triangles[t].tetrahedron;
      scalars->InsertNextValue(tetrahedron < 0 ? std::numeric_limits<double>::quiet_NaN() : values[tetrahedron]);
    }
    faces_->GetPointData()->SetScalars(nullptr);
    faces_->GetCellData()->SetScalars(scalars);
    mapper_->SetScalarModeToUseCellData();
  }
  mapper_->SetColorModeToMapScalars();
  mapper_->SetLookupTable(&table);
  mapper_->SetScalarRange(low, high);
}

void BlockActors::draw_edges(double block_edges, double mesh_edges, Rgb colour, const Vec3& pixel) {
  constexpr double too_short = 5;  // pixels: half the side of triangles whose lines are drawn in full
  if (mesh_edges > 0) show_mesh_lines(too_short * pixel.norm());
  const auto draw = [&](vtkActor& actor, double width, double spacing, double lift) {
    constexpr double seen = 0.02;
    const double strength = strength_of_lines(spacing / pixel.norm());
    actor.SetVisibility(width > 0 && strength > seen);
    LineMapper::style(actor, width, strength);
    set_colour(*actor.GetProperty(), colour);
    bring_nearer(actor, lift, pixel);
  };
  draw(*sharp_edge_actor_, block_edges, spacing_of_edges_, lift_of_edges);
  draw(*mesh_actor_, mesh_edges, spacing_of_mesh_, lift_of_mesh);
}

Highlight::Highlight(const Parts& parts) : parts_(parts) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Layer& layer = layers_[i];
    for (vtkPolyData* data : {layer.faces.Get(), layer.lines.Get()}) data->SetPoints(&parts_[i]->points());
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(layer.faces);
    mapper->ScalarVisibilityOff();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -1);
    layer.face_actor->SetMapper(mapper);
    layer.face_actor->GetProperty()->SetLighting(false);
  }
}

void Highlight::add_to(vtkRenderer& renderer) {
  for (Layer& layer : layers_) {
    renderer.AddActor(layer.face_actor);
    add_lines(renderer, *layer.lines, *layer.line_actor);
  }
}

void Highlight::mark(std::span<const int> blocks) { mark(blocks, {}); }

void Highlight::mark(int block, const Chosen& chosen) { mark({&block, 1}, chosen); }

void Highlight::mark(std::span<const int> blocks, const Chosen& chosen) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const BlockActors& part = *parts_[i];
    const BlockSurface& surface = part.surface();
    std::vector<int> triangles, edges;
    for (const int block : blocks) {
      if (!part.shows(block)) continue;
      const auto &begin = surface.begins[static_cast<std::size_t>(block)],
                 &end = surface.begins[static_cast<std::size_t>(block) + 1];
      std::vector<bool> touched(static_cast<std::size_t>(end.vertex - begin.vertex), !chosen);
      for (int t = begin.triangle; t < end.triangle; ++t) {
        const BlockSurface::Triangle& triangle = surface.triangles[static_cast<std::size_t>(t)];
        if (chosen && !chosen(surface, triangle)) continue;
        triangles.insert(triangles.end(), triangle.vertices.begin(), triangle.vertices.end());
        for (const int vertex : triangle.vertices) touched[static_cast<std::size_t>(vertex - begin.vertex)] = true;
      }
      const auto is_touched = [&](int vertex) { return touched[static_cast<std::size_t>(vertex - begin.vertex)]; };
      for (int e = begin.edge; e < end.edge; ++e) {
        const BlockSurface::Edge& edge = surface.edges[static_cast<std::size_t>(e)];
        if (edge.sharp && std::ranges::all_of(edge.vertices, is_touched))
          edges.insert(edges.end(), edge.vertices.begin(), edge.vertices.end());
      }
    }
    vtkNew<vtkCellArray> polygons, lines;
    set_cells(*polygons, 3, triangles);
    set_cells(*lines, 2, edges);
    layers_[i].faces->SetPolys(polygons);
    layers_[i].lines->SetLines(lines);
  }
}

void Highlight::cut_by(vtkPlane* plane) {
  for (Layer& layer : layers_)
    for (vtkActor* actor : {layer.face_actor.Get(), layer.line_actor.Get()}) clip(*actor, plane);
}

void Highlight::style(Rgb colour, double line_width, double tint, const Vec3& pixel) {
  for (Layer& layer : layers_) {
    const bool marks = layer.faces->GetNumberOfPolys() > 0;
    set_colour(*layer.face_actor->GetProperty(), colour);
    set_colour(*layer.line_actor->GetProperty(), colour);
    layer.face_actor->GetProperty()->SetOpacity(tint);
    layer.face_actor->SetVisibility(marks && tint > 0);
    layer.line_actor->SetVisibility(marks);
    LineMapper::style(*layer.line_actor, line_width);
    bring_nearer(*layer.line_actor, lift_of_marks, pixel);
  }
}

}  // namespace talus
