#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "model/project.hpp"

/// A box that is divided among seeds: to each what is nearer to it than to any other (Voronoi). Polyhedra that touch
/// along whole faces.
namespace talus::voronoi {

/// `across`: number of the neighbouring cell; negative: a side of the box.
struct Face {
  std::vector<Vec3> corners;  ///< counter-clockwise seen from outside
  int across = 0;
};
using Cell = std::vector<Face>;

inline Cell box_cell(const Vec3& sides) {
  const auto at = [&](int k) { return Vec3((k & 1) * sides.x(), (k >> 1 & 1) * sides.y(), (k >> 2) * sides.z()); };
  Cell cell;
  int side = 0;
  for (const auto& face : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                           std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}})
    cell.push_back({{at(face[0]), at(face[1]), at(face[2]), at(face[3])}, --side});
  return cell;
}

/// Those points of a plane in order around their middle, counter-clockwise about the normal, each once.
inline std::vector<Vec3> around(std::vector<Vec3> points, const Vec3& normal) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& point : points) middle += point / static_cast<double>(points.size());
  const Vec3 u = (points[0] - middle).normalized(), v = normal.cross(u);
  const auto angle = [&](const Vec3& p) { return std::atan2(v.dot(p - middle), u.dot(p - middle)); };
  std::sort(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) { return angle(a) < angle(b); });
  const auto same = [](const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-9; };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  if (same(points.front(), points.back())) points.pop_back();
  return points;
}

/// What lies below the plane.
inline Cell below(const Cell& cell, const Vec3& normal, double offset, int across) {
  Cell kept;
  std::vector<Vec3> section;
  for (const Face& face : cell) {
    Face part{{}, face.across};
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      const Vec3 &a = face.corners[k], &b = face.corners[(k + 1) % face.corners.size()];
      const double from = normal.dot(a) - offset, to = normal.dot(b) - offset;
      if (from <= 0) part.corners.push_back(a);
      if (from * to >= 0) continue;
      const bool up = from < 0;  // the same point from both faces of an edge
      const Vec3 crossing = up ? Vec3(a + from / (from - to) * (b - a)) : Vec3(b + to / (to - from) * (a - b));
      part.corners.push_back(crossing);
      section.push_back(crossing);
    }
    if (part.corners.size() > 2) kept.push_back(std::move(part));
  }
  if (section.size() > 2) kept.push_back({around(std::move(section), normal), across});
  return kept;
}

/// The cells of `count` seeds in a box from the origin.
inline std::vector<Cell> cells(const Vec3& sides, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vec3> seeds;
  for (int i = 0; i < count; ++i) {
    Vec3 place;
    for (int k = 0; k < 3; ++k) place[k] = sides[k] * (random() / 4294967296.0);
    seeds.push_back(place);
  }
  std::vector<Cell> made;
  for (int i = 0; i < count; ++i) {
    Cell cell = box_cell(sides);
    for (int j = 0; j < count; ++j) {
      if (j == i) continue;
      const Vec3 normal = (seeds[j] - seeds[i]).normalized();
      cell = below(cell, normal, normal.dot((seeds[i] + seeds[j]) / 2), j);
    }
    made.push_back(std::move(cell));
  }
  return made;
}

inline PolyhedronShape polyhedron(const Cell& cell) {
  PolyhedronShape shape;
  for (const Face& face : cell) {
    std::vector<int> loop;
    for (const Vec3& corner : face.corners) {
      const auto known = std::find_if(shape.vertices.begin(), shape.vertices.end(),
                                      [&](const Vec3& vertex) { return (vertex - corner).norm() < 1e-9; });
      loop.push_back(static_cast<int>(known - shape.vertices.begin()));
      if (known == shape.vertices.end()) shape.vertices.push_back(corner);
    }
    shape.faces.push_back(std::move(loop));
  }
  return shape;
}

}  // namespace talus::voronoi
