#include "render/scene/plane_section.hpp"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace talus {
namespace {

/// Where an edge of the surface passes the plane: the same to the last bit for both triangles at it.
Vec3 crossing(const RockSurface& rock, const std::array<double, 3>& height, const std::array<int, 3>& triangle, int i,
              int k) {
  if (triangle[i] > triangle[k]) std::swap(i, k);
  const Vec3 &from = rock.points[static_cast<std::size_t>(triangle[i])],
             &to = rock.points[static_cast<std::size_t>(triangle[k])];
  return from + height[i] / (height[i] - height[k]) * (to - from);
}

}  // namespace

PlaneSection::PlaneSection(const Vec3& point, const Vec3& normal)
    : point_(point), along_(normal.unitOrthogonal()), across_(normal.normalized().cross(along_)) {}

PlaneSection::PlaneSection(const RockSurface& rock, const Vec3& point, const Vec3& normal)
    : PlaneSection(point, normal) {
  for (const auto& triangle : rock.triangles) cross(rock, triangle, normal);
}

PlaneSection::PlaneSection(const SurfaceTree& rock, const Vec3& point, const Vec3& normal)
    : PlaneSection(point, normal) {
  for (const int t : rock.near_plane(point, normal))
    cross(rock.rock(), rock.rock().triangles[static_cast<std::size_t>(t)], normal);
}

PlaneSection PlaneSection::of_polygon(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
  PlaneSection section(point, normal);
  for (std::size_t i = 0; i < corners.size(); ++i)
    section.edges_.push_back({section.flat(corners[i]), section.flat(corners[(i + 1) % corners.size()])});
  return section;
}

void PlaneSection::cross(const RockSurface& rock, const std::array<int, 3>& triangle, const Vec3& normal) {
  std::array<double, 3> height{};
  for (int i = 0; i < 3; ++i) height[i] = normal.dot(rock.points[static_cast<std::size_t>(triangle[i])] - point_);
  // A point on the plane counts as above it: a closed surface then has closed lines in every plane.
  const bool one = height[0] >= 0, two = height[1] >= 0, three = height[2] >= 0;
  if (one == two && two == three) return;
  const int alone = two == three ? 0 : one == three ? 1 : 2;
  const int next = alone == 0 ? 1 : 0, last = alone == 2 ? 1 : 2;
  edges_.push_back(
      {flat(crossing(rock, height, triangle, alone, next)), flat(crossing(rock, height, triangle, alone, last))});
}

void PlaneSection::clip(const HalfSpace& to, bool bordered) {
  const Vec2 gradient(to.inwards.dot(along_), to.inwards.dot(across_));
  const double at_point = to.inwards.dot(point_ - to.point);
  const auto inside = [&](const Vec2& p) { return at_point + gradient.dot(p); };
  std::vector<Piece> kept;
  std::vector<Vec2> cuts;  // of edges by the border
  for (const Piece& edge : edges_) {
    const double from = inside(edge.from), end = inside(edge.to);
    if (from >= 0 && end >= 0) kept.push_back(edge);
    if ((from >= 0) == (end >= 0)) continue;
    const Vec2 cut = edge.from + from / (from - end) * (edge.to - edge.from);
    cuts.push_back(cut);
    kept.push_back(from >= 0 ? Piece{edge.from, cut, edge.bordered} : Piece{cut, edge.to, edge.bordered});
  }
  // Along the border the area begins and ends in turn.
  const Vec2 border(-gradient.y(), gradient.x());
  std::ranges::sort(cuts, {}, [&](const Vec2& p) { return border.dot(p); });
  for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) kept.push_back({cuts[i], cuts[i + 1], bordered});
  edges_ = std::move(kept);
}

std::vector<FlatTriangle> PlaneSection::triangles() const {
  // Strips from end to end of edges, across which no edge ends: in each the area is a row of trapezoids.
  std::vector<Piece> edges;  // from left to right
  std::vector<double> ends;
  for (const Piece& edge : edges_) {
    edges.push_back(edge.from.x() <= edge.to.x() ? edge : Piece{edge.to, edge.from});
    ends.insert(ends.end(), {edge.from.x(), edge.to.x()});
  }
  std::ranges::sort(edges, {}, [](const Piece& edge) { return edge.from.x(); });
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const auto height = [](const Piece& edge, double x) {
    const double share = (x - edge.from.x()) / (edge.to.x() - edge.from.x());
    return edge.from.y() + share * (edge.to.y() - edge.from.y());
  };
  std::vector<FlatTriangle> triangles;
  std::vector<const Piece*> across;  // edges that reach over the strip
  auto next = edges.begin();
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double left = ends[i], right = ends[i + 1], middle = (left + right) / 2;
    std::erase_if(across, [&](const Piece* edge) { return edge->to.x() < right; });
    for (; next != edges.end() && next->from.x() <= left; ++next)
      if (next->to.x() >= right) across.push_back(&*next);
    std::ranges::sort(across, {}, [&](const Piece* edge) { return height(*edge, middle); });
    for (std::size_t k = 0; k + 1 < across.size(); k += 2) {
      const Vec3 low_left = place({left, height(*across[k], left)}), low = place({right, height(*across[k], right)});
      const Vec3 high_left = place({left, height(*across[k + 1], left)}),
                 high = place({right, height(*across[k + 1], right)});
      triangles.push_back({low_left, low, high});
      triangles.push_back({low_left, high, high_left});
    }
  }
  return triangles;
}

std::vector<Edge> PlaneSection::outline() const {
  std::vector<Edge> outline;
  for (const Piece& edge : edges_)
    if (edge.bordered) outline.push_back({place(edge.from), place(edge.to)});
  return outline;
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
  const auto corner = [&](vtkIdType i) { return corners[static_cast<std::size_t>(ids->GetId(i))]; };
  std::vector<FlatTriangle> triangles;
  for (vtkIdType i = 0; i + 2 < ids->GetNumberOfIds(); i += 3)
    triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
  return triangles;
}

}  // namespace talus
