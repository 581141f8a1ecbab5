#include "render/scene/block_actors.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <limits>
#include <map>

namespace talus {
namespace {

void set_colour(vtkProperty& property, Rgb colour) {
  property.SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

void matt(vtkProperty& property) {
  property.SetInterpolationToFlat();  // rock breaks along planes; normals then need no upkeep while it moves
  property.SetAmbient(0.36);
  property.SetDiffuse(0.74);
  property.SetSpecular(0);
}

void insert(vtkCellArray& cells, std::initializer_list<int> vertices) {
  cells.InsertNextCell(static_cast<int>(vertices.size()));
  for (const int vertex : vertices) cells.InsertCellPoint(vertex);
}

void set_lines(vtkPolyData& lines, const BlockSurface& surface,
               const std::function<bool(const BlockSurface::Edge&)>& wanted) {
  vtkNew<vtkCellArray> cells;
  for (const BlockSurface::Edge& edge : surface.edges)
    if (wanted(edge)) insert(*cells, {edge.vertices[0], edge.vertices[1]});
  lines.SetLines(cells);
}

void set_points(vtkPoints& points, std::span<const Vec3> positions, const Vec3& origin) {
  points.SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 p = positions[i] - origin;
    points.SetPoint(static_cast<vtkIdType>(i), p.data());
  }
  points.Modified();
}

/// For each vertex, from the origin to the mean of its block's vertices, m.
std::vector<Vec3> ways_to_blocks(const BlockSurface& surface, const Vec3& origin) {
  std::vector<int> block_of(surface.rest.size(), 0);
  for (const BlockSurface::Triangle& triangle : surface.triangles)
    for (const int vertex : triangle.vertices) block_of[static_cast<std::size_t>(vertex)] = triangle.block;
  std::map<int, std::pair<Vec3, int>> sums;  // by block: of its vertices, and how many they are
  for (std::size_t i = 0; i < surface.rest.size(); ++i) {
    auto& [sum, count] = sums.try_emplace(block_of[i], Vec3::Zero(), 0).first->second;
    sum += surface.rest[i] - origin;
    ++count;
  }
  std::vector<Vec3> ways;
  for (const int block : block_of) ways.push_back(sums[block].first / sums[block].second);
  return ways;
}

constexpr double thinnest_line = 1.05;  // pixels; a thinner one passes between their centres and looks dashed

/// Lines lie on faces: they are drawn as if a little nearer, `lift` depth steps, or half of each would vanish.
void add_lines(vtkRenderer& renderer, vtkPolyData& lines, vtkActor& actor, int lift) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&lines);
  mapper->ScalarVisibilityOff();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-lift, -lift);
  actor.SetMapper(mapper);
  actor.GetProperty()->SetLighting(false);
  renderer.AddActor(&actor);
}

}  // namespace

BlockActors::BlockActors(BlockSurface surface, const Vec3& origin)
    : surface_(std::move(surface)),
      origin_(origin),
      from_origin_(ways_to_blocks(surface_, origin)),
      positions_(surface_.rest) {
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  points_->SetDataTypeToDouble();
  for (vtkPolyData* data : {faces_.Get(), sharp_edges_.Get(), mesh_lines_.Get()}) data->SetPoints(points_);
  set_points(*points_, positions_, origin_);
  mapper_->SetInputData(faces_);
  mapper_->SetInterpolateScalarsBeforeMapping(true);
  face_actor_->SetMapper(mapper_);
  matt(*face_actor_->GetProperty());
  show(std::vector<bool>(1 + (surface_.triangles.empty() ? 0 : surface_.triangles.back().block), true));
}

void BlockActors::add_to(vtkRenderer& renderer) {
  renderer.AddActor(face_actor_);
  add_lines(renderer, *sharp_edges_, *sharp_edge_actor_, 2);
  add_lines(renderer, *mesh_lines_, *mesh_actor_, 2);
}

void BlockActors::move(std::span<const Vec3> displacement, double scale, double explosion) {
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    positions_[i] = surface_.rest[i];
    if (!displacement.empty()) positions_[i] += scale * displacement[surface_.nodes[i]];
    positions_[i] += explosion * from_origin_[i];
  }
  set_points(*points_, positions_, origin_);
}

void BlockActors::show(const std::vector<bool>& shown) {
  vtkNew<vtkCellArray> polygons;
  drawn_.clear();
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
    const BlockSurface::Triangle& triangle = surface_.triangles[t];
    if (!shown[triangle.block]) continue;
    insert(*polygons, {triangle.vertices[0], triangle.vertices[1], triangle.vertices[2]});
    drawn_.push_back(static_cast<int>(t));
  }
  faces_->SetPolys(polygons);
  faces_->GetCellData()->SetScalars(nullptr);  // belonged to the former cells; colouring follows
  set_lines(*sharp_edges_, surface_, [&](const BlockSurface::Edge& edge) { return edge.sharp && shown[edge.block]; });
  set_lines(*mesh_lines_, surface_, [&](const BlockSurface::Edge& edge) { return !edge.sharp && shown[edge.block]; });
}

void BlockActors::let_through(double opacity) {
  face_actor_->GetProperty()->SetOpacity(opacity);
  face_actor_->GetProperty()->SetBackfaceCulling(opacity < 1);
}

void BlockActors::colour_by_block(const std::function<Rgb(int)>& colour) {
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(drawn_.size()));
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    const Rgb c = colour(surface_.triangles[drawn_[i]].block);
    const unsigned char tuple[] = {c.red, c.green, c.blue};
    colours->SetTypedTuple(static_cast<vtkIdType>(i), tuple);
  }
  faces_->GetPointData()->SetScalars(nullptr);
  faces_->GetCellData()->SetScalars(colours);
  mapper_->SetScalarModeToUseCellData();
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
    for (const int t : drawn_) {
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

void BlockActors::draw_edges(double block_edges, double mesh_edges, Rgb colour) {
  sharp_edge_actor_->SetVisibility(block_edges > 0);
  mesh_actor_->SetVisibility(mesh_edges > 0);
  sharp_edge_actor_->GetProperty()->SetLineWidth(static_cast<float>(std::max(thinnest_line, block_edges)));
  mesh_actor_->GetProperty()->SetLineWidth(static_cast<float>(std::max(thinnest_line, mesh_edges)));
  for (vtkActor* actor : {sharp_edge_actor_.Get(), mesh_actor_.Get()}) set_colour(*actor->GetProperty(), colour);
}

Highlight::Highlight() {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(faces_);
  mapper->ScalarVisibilityOff();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -1);
  face_actor_->SetMapper(mapper);
  face_actor_->GetProperty()->SetLighting(false);
}

void Highlight::add_to(vtkRenderer& renderer) {
  renderer.AddActor(face_actor_);
  add_lines(renderer, *lines_, *line_actor_, 20);
}

void Highlight::mark(std::span<const BlockActors* const> parts, const Vec3& origin, const std::vector<bool>& marked) {
  mark(parts, origin, [&](const BlockSurface&, const BlockSurface::Triangle& t) { return marked[t.block]; });
}

void Highlight::mark(std::span<const BlockActors* const> parts, const Vec3& origin, const Chosen& marked) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons, lines;
  for (const BlockActors* part : parts) {
    const auto place = [&](int vertex) {
      const Vec3 p = part->positions()[vertex] - origin;
      return static_cast<int>(points->InsertNextPoint(p.data()));
    };
    std::vector<bool> touched(part->positions().size(), false);
    for (const int t : part->drawn()) {
      const BlockSurface::Triangle& triangle = part->surface().triangles[t];
      if (!marked(part->surface(), triangle)) continue;
      const auto& v = triangle.vertices;
      insert(*polygons, {place(v[0]), place(v[1]), place(v[2])});
      for (const int vertex : v) touched[static_cast<std::size_t>(vertex)] = true;
    }
    for (const BlockSurface::Edge& edge : part->surface().edges)
      if (edge.sharp && touched[edge.vertices[0]] && touched[edge.vertices[1]])
        insert(*lines, {place(edge.vertices[0]), place(edge.vertices[1])});
  }
  faces_->SetPoints(points);
  faces_->SetPolys(polygons);
  lines_->SetPoints(points);
  lines_->SetLines(lines);
}

void Highlight::style(Rgb colour, double line_width, double tint) {
  set_colour(*face_actor_->GetProperty(), colour);
  set_colour(*line_actor_->GetProperty(), colour);
  face_actor_->GetProperty()->SetOpacity(tint);
  face_actor_->SetVisibility(any() && tint > 0);
  line_actor_->SetVisibility(any());
  line_actor_->GetProperty()->SetLineWidth(static_cast<float>(line_width));
}

bool Highlight::any() const { return faces_->GetNumberOfPolys() > 0; }

}  // namespace talus
