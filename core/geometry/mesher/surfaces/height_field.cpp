#include "geometry/mesher/surfaces/height_field.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "base/error.hpp"
#include "geometry/mesher/surfaces/plan_triangulation.hpp"

namespace talus {
namespace {

constexpr double rounding = 1e-6;  // of the diagonal: what coordinates of files are rounded by

double thin_for(const std::vector<Vec3>& points) {
  Eigen::AlignedBox3d bounds;
  for (const Vec3& point : points) bounds.extend(point);
  return rounding * bounds.diagonal().head<2>().norm();
}

std::string coordinates(const Vec3& point) {
  std::ostringstream text;
  text << "(" << point.x() << ", " << point.y() << ", " << point.z() << ")";
  return text.str();
}

/// In order of x and y; of those in one place the highest.
std::vector<Vec3> highest_of_each_place(std::vector<Vec3> points) {
  const auto order = [](const Vec3& p) { return std::tuple(p.x(), p.y(), -p.z()); };
  std::sort(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) { return order(a) < order(b); });
  const auto same_place = [](const Vec3& a, const Vec3& b) { return a.x() == b.x() && a.y() == b.y(); };
  points.erase(std::unique(points.begin(), points.end(), same_place), points.end());
  return points;
}

/// With the points that triangles use, and no others.
HeightField field_of(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles) {
  HeightField field;
  std::vector<int> number(points.size(), -1);
  for (auto triangle : triangles) {
    for (int& v : triangle) {
      int& known = number[static_cast<std::size_t>(v)];
      if (known < 0) {
        known = static_cast<int>(field.points.size());
        field.points.push_back(points[static_cast<std::size_t>(v)]);
      }
      v = known;
    }
    field.triangles.push_back(triangle);
  }
  return field;
}

/// Twice the area in plan.
double area_in_plan(const std::vector<Vec3>& points, const std::array<int, 3>& t) {
  const Vec3& a = points[static_cast<std::size_t>(t[0])];
  return (points[static_cast<std::size_t>(t[1])] - a).cross(points[static_cast<std::size_t>(t[2])] - a).z();
}

[[noreturn]] void refuse_overhang(const std::string& place, const Vec3& where) {
  throw InputError(place, "has a wall or an overhang around " + coordinates(where),
                   "read it as a closed solid, or give a surface that each vertical line meets once");
}

void check_is_height_field(const TriangleSoup& soup, const std::string& place) {
  std::map<std::pair<double, double>, double> height;
  for (const Vec3& point : soup.points)
    if (!height.emplace(std::pair(point.x(), point.y()), point.z()).second) refuse_overhang(place, point);
  const double thin = thin_for(soup.points);
  for (const auto& triangle : soup.triangles)
    if (std::abs(area_in_plan(soup.points, triangle)) < thin * thin)
      refuse_overhang(place, soup.points[static_cast<std::size_t>(triangle[0])]);
}

/// Points of faces without area alone are no part of the surface.
TriangleSoup without_lost_points(const TriangleSoup& given) {
  TriangleSoup soup;
  std::vector<int> number(given.points.size(), -1);
  for (auto triangle : given.triangles) {
    for (int& v : triangle) {
      int& now = number[static_cast<std::size_t>(v)];
      if (now < 0) {
        now = static_cast<int>(soup.points.size());
        soup.points.push_back(given.points[static_cast<std::size_t>(v)]);
      }
      v = now;
    }
    soup.triangles.push_back(triangle);
  }
  return soup;
}

std::vector<std::array<int, 3>> turned_upwards(const TriangleSoup& soup) {
  std::vector<std::array<int, 3>> triangles = soup.triangles;
  for (auto& triangle : triangles)
    if (area_in_plan(soup.points, triangle) < 0) std::swap(triangle[1], triangle[2]);
  return triangles;
}

using Edges = std::vector<std::array<int, 2>>;

/// Edges that one triangle alone has, as it runs along them.
Edges rim_of(const std::vector<std::array<int, 3>>& triangles) {
  std::set<std::array<int, 2>> open;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) open.insert({t[k], t[(k + 1) % 3]});
  Edges rim;
  for (const auto& [a, b] : open)
    if (!open.contains({b, a})) rim.push_back({a, b});
  return rim;
}

Edges all_edges(const std::vector<std::array<int, 3>>& triangles) {
  std::set<std::array<int, 2>> edges;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
  return {edges.begin(), edges.end()};
}

std::vector<int> ends_of(const Edges& edges) {
  std::set<int> ends;
  for (const auto& [a, b] : edges) ends.insert({a, b});
  return {ends.begin(), ends.end()};
}

/// Two sheets that meet in a point alone would leave a wall with four sides there.
void check_rim(const HeightField& surface, const Edges& rim, const std::string& place) {
  std::set<int> starts;
  for (const auto& [a, b] : rim)
    if (!starts.insert(a).second)
      throw InputError(
          place, "has two sheets that meet in one point " + coordinates(surface.points[static_cast<std::size_t>(a)]),
          "join or part them there");
}

}  // namespace

HeightField height_field(const std::vector<Vec3>& given, double tolerance, const std::string& place) {
  const std::vector<Vec3> points = highest_of_each_place(given);
  const double thin = thin_for(points);
  const std::vector<int> hull = points.size() < 3 ? std::vector<int>{} : hull_in_plan(points, thin);
  if (hull.size() < 3)
    throw InputError(place, "has " + std::to_string(points.size()) + " points, which span no surface in plan",
                     "give at least three points that are not in one line");
  PlanTriangulation plan(points);
  plan.take(hull);
  if (tolerance > 0) {
    plan.refine(tolerance);
  } else {
    std::vector<int> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    plan.take(all);
  }
  return field_of(points, plan.triangles(thin));
}

HeightField height_field(const TriangleSoup& given, double tolerance, const std::string& place) {
  const TriangleSoup soup = without_lost_points(given);
  if (soup.triangles.empty()) throw InputError(place, "all of its faces are without area", "export the surface again");
  check_is_height_field(soup, place);
  const auto triangles = turned_upwards(soup);
  const Edges edges = all_edges(triangles);
  PlanTriangulation whole(soup.points);
  whole.take(ends_of(edges));
  if (const int crossing = whole.keep_edges(edges); crossing >= 0)
    refuse_overhang(place, soup.points[static_cast<std::size_t>(crossing)]);
  if (!(tolerance > 0)) return field_of(soup.points, triangles);
  const Edges rim = rim_of(triangles);
  PlanTriangulation thinned(soup.points);
  thinned.take(ends_of(rim));
  thinned.keep_edges(rim);
  thinned.refine(tolerance);
  return field_of(soup.points, thinned.triangles_within_edges());
}

TriangleSolid solid_below(const HeightField& surface, double base, const std::string& place) {
  const auto lowest = std::min_element(surface.points.begin(), surface.points.end(),
                                       [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  if (lowest->z() <= base) {
    std::ostringstream problem;
    problem << "its base, " << base << " m, is not below the surface, whose lowest point " << coordinates(*lowest)
            << " is at " << lowest->z() << " m";
    throw InputError(place, problem.str(), "give a lower base");
  }
  TriangleSolid solid;
  const int count = static_cast<int>(surface.points.size());
  solid.vertices = surface.points;
  for (const Vec3& point : surface.points) solid.vertices.emplace_back(point.x(), point.y(), base);
  solid.triangles = surface.triangles;
  for (const auto& [a, b, c] : surface.triangles) solid.triangles.push_back({count + a, count + c, count + b});
  solid.surface_triangles = static_cast<int>(surface.triangles.size());
  const Edges rim = rim_of(surface.triangles);
  check_rim(surface, rim, place);
  for (const auto& [a, b] : rim) {
    solid.triangles.push_back({count + a, count + b, b});
    solid.triangles.push_back({count + a, b, a});
  }
  return solid;
}

}  // namespace talus
