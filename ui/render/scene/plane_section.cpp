#include "render/scene/plane_section.hpp"

#include <vtkCellArray.h>
#include <vtkContourTriangulator.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

namespace talus {
namespace {

constexpr double least_share = 1e-9;  // of a size: what is smaller is nothing

/// Lines along which a plane crosses a surface, with the inside of the rock to their left.
class Contour {
 public:
  Contour(const RockSurface& rock, const Vec3& point, const Vec3& normal) : rock_(rock) {
    points_->SetDataTypeToDouble();
    height_.reserve(rock.points.size());
    for (const Vec3& p : rock.points) height_.push_back(normal.dot(p - point));
    for (const auto& triangle : rock.triangles) cross(triangle);
    lines_->SetPoints(points_);
    lines_->SetLines(cells_);
  }
  vtkPolyData& lines() { return *lines_; }

 private:
  // A point on the plane counts as above it: every closed surface then has closed lines.
  bool above(int i) const { return height_[static_cast<std::size_t>(i)] >= 0; }

  void cross(const std::array<int, 3>& triangle) {
    for (int i = 0; i < 3; ++i) {
      const int alone = triangle[i], next = triangle[(i + 1) % 3], last = triangle[(i + 2) % 3];
      if (above(alone) == above(next) || above(next) != above(last)) continue;
      const vtkIdType first = crossing(alone, last), second = crossing(alone, next);
      const vtkIdType ends[] = {above(alone) ? second : first, above(alone) ? first : second};
      if (ends[0] != ends[1]) cells_->InsertNextCell(2, ends);
      return;
    }
  }

  /// One point for all triangles at an edge.
  vtkIdType crossing(int a, int b) {
    if (a > b) std::swap(a, b);
    const auto [found, isNew] = crossings_.try_emplace({a, b}, 0);
    if (isNew) {
      const double from = height_[static_cast<std::size_t>(a)], to = height_[static_cast<std::size_t>(b)];
      const Vec3 p =
          rock_.points[static_cast<std::size_t>(a)] +
          from / (from - to) * (rock_.points[static_cast<std::size_t>(b)] - rock_.points[static_cast<std::size_t>(a)]);
      found->second = points_->InsertNextPoint(p.data());
    }
    return found->second;
  }

  const RockSurface& rock_;
  std::vector<double> height_;
  std::map<std::array<int, 2>, vtkIdType> crossings_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkPolyData> lines_;
};

std::vector<FlatTriangle> triangles_in(vtkPolyData& mesh) {
  std::vector<FlatTriangle> triangles;
  vtkNew<vtkIdList> corners;
  for (mesh.GetPolys()->InitTraversal(); mesh.GetPolys()->GetNextCell(corners);) {
    FlatTriangle& triangle = triangles.emplace_back();
    for (int i = 0; i < 3; ++i) mesh.GetPoint(corners->GetId(i), triangle[static_cast<std::size_t>(i)].data());
  }
  return triangles;
}

/// Sutherland and Hodgman (1974), one side.
std::vector<Vec3> clipped_polygon(const std::vector<Vec3>& polygon, const HalfSpace& side) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = side.inwards.dot(a - side.point), to = side.inwards.dot(b - side.point);
    if (from >= 0) kept.push_back(a);
    if ((from >= 0) != (to >= 0)) kept.push_back(a + from / (from - to) * (b - a));
  }
  return kept;
}

}  // namespace

std::vector<FlatTriangle> plane_section(const RockSurface& rock, const Vec3& point, const Vec3& normal) {
  Contour contour(rock, point, normal);
  if (contour.lines().GetNumberOfLines() == 0) return {};
  vtkNew<vtkContourTriangulator> fill;
  fill->SetInputData(&contour.lines());
  fill->TriangulationErrorDisplayOff();
  fill->Update();
  return triangles_in(*fill->GetOutput());
}

std::vector<FlatTriangle> clipped(std::vector<FlatTriangle> triangles, std::span<const HalfSpace> to) {
  for (const HalfSpace& side : to) {
    std::vector<FlatTriangle> kept;
    for (const FlatTriangle& triangle : triangles) {
      const std::vector<Vec3> polygon = clipped_polygon({triangle.begin(), triangle.end()}, side);
      for (std::size_t i = 2; i < polygon.size(); ++i) kept.push_back({polygon[0], polygon[i - 1], polygon[i]});
    }
    triangles = std::move(kept);
  }
  return triangles;
}

std::vector<HalfSpace> sides_of(std::span<const Vec3> corners, const Vec3& normal) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& corner : corners) middle += corner / static_cast<double>(corners.size());
  std::vector<HalfSpace> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 along = corners[(i + 1) % corners.size()] - corners[i];
    Vec3 inwards = normal.cross(along);
    if (inwards.dot(middle - corners[i]) < 0) inwards = -inwards;
    sides.push_back({corners[i], inwards});
  }
  return sides;
}

std::vector<FlatTriangle> triangles_of(std::span<const Vec3> corners) {
  vtkNew<vtkPolygon> polygon;
  for (const Vec3& corner : corners) {
    polygon->GetPointIds()->InsertNextId(polygon->GetPoints()->GetNumberOfPoints());
    polygon->GetPoints()->InsertNextPoint(corner.data());
  }
  vtkNew<vtkIdList> ids;
  polygon->Triangulate(ids);
  std::vector<FlatTriangle> triangles;
  for (vtkIdType i = 0; i + 2 < ids->GetNumberOfIds(); i += 3)
    triangles.push_back({corners[static_cast<std::size_t>(ids->GetId(i))],
                         corners[static_cast<std::size_t>(ids->GetId(i + 1))],
                         corners[static_cast<std::size_t>(ids->GetId(i + 2))]});
  return triangles;
}

std::vector<std::array<Vec3, 2>> outline_of(std::span<const FlatTriangle> triangles) {
  double size = 0;
  for (const FlatTriangle& triangle : triangles) size = std::max(size, (triangle[1] - triangle[0]).norm());
  const double grid = std::max(size, 1e-300) * least_share * 100;  // clipping leaves rounding between neighbours
  using Place = std::array<long long, 3>;
  const auto place = [&](const Vec3& p) {
    return Place{std::llround(p.x() / grid), std::llround(p.y() / grid), std::llround(p.z() / grid)};
  };
  std::map<std::array<Place, 2>, std::pair<int, std::array<Vec3, 2>>> edges;
  for (const FlatTriangle& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = triangle[i], &b = triangle[(i + 1) % 3];
      const Place from = place(a), to = place(b);
      if (from == to) continue;
      auto& [count, ends] = edges[{std::min(from, to), std::max(from, to)}];
      ++count;
      ends = {a, b};
    }
  std::vector<std::array<Vec3, 2>> outline;
  for (const auto& [ignored, edge] : edges)
    if (edge.first == 1) outline.push_back(edge.second);
  return outline;
}

}  // namespace talus
