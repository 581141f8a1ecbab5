#include "geometry/mesher/cells/block_skin.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <deque>
#include <map>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "geometry/mesher/cells/divided_edges.hpp"
#include "geometry/mesher/cells/facet_outlines.hpp"
#include "geometry/mesher/cells/flat_facet.hpp"
#include "mesh/mesh_size.hpp"
#include "model/number_text.hpp"

namespace talus {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
/// The number is how many outlines lie around a triangle; −1: not known yet.
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

Kernel::Point_2 to_point(const Eigen::Vector2d& point) { return {point.x(), point.y()}; }

double length_of(const FacetOutline& outline, const SkinVertices& vertices) {
  Eigen::AlignedBox3d box;
  for (const auto& [from, to] : outline.edges) box.extend(vertices[from]);
  return box.diagonal().norm();
}

[[noreturn]] void throw_needle(double length, const std::string& place) {
  throw InputError(place, "has a face that is " + significant(length, 2) + " m long, and a needle",
                   "look for a wrong height or corner in its solid, or make mesh_size larger");
}

/// The time to triangulate a facet that is one grows with the square of its length, and to divide its edges may take
/// all memory.
void require_no_needle(const FacetOutline& outline, const SkinVertices& vertices, double size,
                       const std::string& place) {
  const double length = length_of(outline, vertices);
  const Vec3 origin = vertices[outline.edges.front().first];
  Vec3 twice_area = Vec3::Zero();
  for (const auto& [from, to] : outline.edges) twice_area += (vertices[from] - origin).cross(vertices[to] - origin);
  if (is_needle(length, twice_area.norm() / 2, size)) throw_needle(length, place);
}

/// Edges that cross each other are those of a needle, which has no room for the bows of its outline.
Triangulation triangulated(const FacetOutline& outline, const FlatFacet& flat, double length,
                           const std::string& place) {
  Triangulation triangulation;
  std::map<int, Triangulation::Vertex_handle> handles;
  for (const auto& [vertex, point] : flat.points()) {
    handles[vertex] = triangulation.insert(to_point(point));
    handles[vertex]->info() = vertex;
  }
  try {
    for (const auto& [from, to] : outline.edges) triangulation.insert_constraint(handles.at(from), handles.at(to));
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    throw_needle(length, place);
  }
  return triangulation;
}

/// Counts how many outlines lie around each triangle, from outside inwards: those with an odd number are the area.
void count_outlines(Triangulation& triangulation) {
  for (auto face : triangulation.all_face_handles()) face->info() = -1;
  std::deque<std::pair<Triangulation::Face_handle, int>> waiting{{triangulation.infinite_face(), 0}};
  while (!waiting.empty()) {
    const auto [face, count] = waiting.front();
    waiting.pop_front();
    if (face->info() >= 0) continue;
    face->info() = count;
    for (int side = 0; side < 3; ++side) {
      if (face->is_constrained(side))
        waiting.emplace_back(face->neighbor(side), count + 1);
      else
        waiting.emplace_front(face->neighbor(side), count);
    }
  }
}

bool is_area(const Triangulation::Face_handle& face) { return face->info() % 2 == 1; }

/// Puts vertices into the area as far apart as the size says.
void fill(Triangulation& triangulation, const FlatFacet& flat, SkinVertices& vertices, const SkinSize& size) {
  std::vector<Eigen::Vector2d> inside;
  for (const Eigen::Vector2d& point : flat.lattice(size)) {
    const auto face = triangulation.locate(to_point(point));
    if (!triangulation.is_infinite(face) && is_area(face)) inside.push_back(point);
  }
  for (const Eigen::Vector2d& point : inside)
    triangulation.insert(to_point(point))->info() = vertices.add(flat.in_space(point));
  count_outlines(triangulation);
}

/// The corners of an outline in order, where it is one loop that turns left at each of them; else none.
std::vector<int> convex_loop(const FacetOutline& outline, const SkinVertices& vertices) {
  std::map<int, int> next(outline.edges.begin(), outline.edges.end());
  std::vector<int> loop{outline.edges.begin()->first};
  while (loop.size() <= next.size() && next.contains(loop.back()) && next.at(loop.back()) != loop.front())
    loop.push_back(next.at(loop.back()));
  if (loop.size() != outline.edges.size()) return {};
  constexpr double straight = 1e-5;
  const std::size_t count = loop.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3& corner = vertices[loop[(k + 1) % count]];
    const Vec3 before = corner - vertices[loop[k]], after = vertices[loop[(k + 2) % count]] - corner;
    const double turn = before.cross(after).dot(outline.normal.normalized());
    if (turn < straight * before.norm() * after.norm()) return {};
  }
  return loop;
}

/// Cuts off the corner with the shortest diagonal until a triangle is left: the same triangles from both sides of a
/// joint, also in a rectangle, where a Delaunay triangulation has the choice.
void take_convex(std::vector<int> loop, int mark, const SkinVertices& vertices, BlockSkin& skin) {
  while (loop.size() > 3) {
    const std::size_t count = loop.size();
    const auto diagonal = [&](std::size_t k) {
      const auto [a, b] = std::minmax(loop[(k + count - 1) % count], loop[(k + 1) % count]);
      return std::tuple((vertices[b] - vertices[a]).norm(), a, b, loop[k]);
    };
    std::size_t shortest = 0;
    for (std::size_t k = 1; k < count; ++k)
      if (diagonal(k) < diagonal(shortest)) shortest = k;
    skin.triangles.push_back({loop[(shortest + count - 1) % count], loop[shortest], loop[(shortest + 1) % count]});
    skin.marks.push_back(mark);
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(shortest));
  }
  skin.triangles.push_back({loop[0], loop[1], loop[2]});
  skin.marks.push_back(mark);
}

}  // namespace

BlockSkin block_skin(const CellSolid& solid, std::span<const int> cells, const SkinSize& size,
                     const std::string& place) {
  std::vector<FacetOutline> outlines = facet_outlines(solid, cells);
  SkinVertices vertices(solid.complex);
  const bool fine = size.own > 0;
  if (fine) {
    for (const FacetOutline& outline : outlines) require_no_needle(outline, vertices, size.own, place);
    divide_edges(outlines, vertices, size);
  }
  BlockSkin skin;
  for (const FacetOutline& outline : outlines) {
    if (!fine) {
      if (std::vector<int> loop = convex_loop(outline, vertices); !loop.empty()) {
        take_convex(std::move(loop), outline.mark, vertices, skin);
        continue;
      }
    }
    const FlatFacet flat(outline, vertices);
    Triangulation triangulation = triangulated(outline, flat, length_of(outline, vertices), place);
    count_outlines(triangulation);
    if (fine) fill(triangulation, flat, vertices, size);
    for (const auto& face : triangulation.finite_face_handles()) {
      if (!is_area(face)) continue;
      skin.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
      skin.marks.push_back(outline.mark);
    }
  }
  skin.more = vertices.take_more();
  return skin;
}

}  // namespace talus
