#include "geometry/mesher/surfaces/mended_surface.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace talus {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Kind = SurfaceFinding::Kind;

Vec3 vector_of(const Point& point) { return {point.x(), point.y(), point.z()}; }

class Mender {
 public:
  explicit Mender(const TriangleSoup& soup) : soup_(soup) {
    for (const Vec3& point : soup.points) bounds_.extend(point);
  }

  MendedSurface mended() {
    note(Kind::duplicate_vertex, soup_.joined, true);
    hang_together();
    leave_degenerate_faces_out();
    fill_holes();
    note_tiny_faces();
    const bool crossing = note_self_intersections();
    if (mesh_.number_of_faces() > 0 && CGAL::is_closed(mesh_) && !crossing) {
      pmp::orient_to_bound_a_volume(mesh_);
      note_bodies();
    }
    MendedSurface result;
    result.surface = surface();
    note_turned_faces(result.surface);
    result.findings = std::move(findings_);
    return result;
  }

 private:
  void note(Kind kind, const std::vector<Vec3>& places, bool is_mended) {
    if (!places.empty()) findings_.push_back({kind, static_cast<int>(places.size()), places.front(), is_mended});
  }

  Vec3 middle_of(Mesh::Face_index face) const {
    Vec3 sum = Vec3::Zero();
    for (const auto v : vertices_around_face(mesh_.halfedge(face), mesh_)) sum += vector_of(mesh_.point(v));
    return sum / 3;
  }

  /// The soup as a mesh whose faces turn alike where they meet.
  void hang_together() {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    for (const Vec3& point : soup_.points) points.emplace_back(point.x(), point.y(), point.z());
    for (const auto& [a, b, c] : soup_.triangles)
      polygons.push_back({static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
    pmp::orient_polygon_soup(points, polygons);
    std::vector<Vec3> parted;
    for (std::size_t i = soup_.points.size(); i < points.size(); ++i) parted.push_back(vector_of(points[i]));
    note(Kind::not_manifold, parted, true);
    pmp::remove_isolated_points_in_polygon_soup(points, polygons);
    pmp::polygon_soup_to_polygon_mesh(points, polygons, mesh_);
  }

  void leave_degenerate_faces_out() {
    std::vector<Mesh::Face_index> flat;
    pmp::degenerate_faces(mesh_, std::back_inserter(flat));
    std::vector<Vec3> places = soup_.left_out;
    for (const auto face : flat) places.push_back(middle_of(face));
    if (!flat.empty()) pmp::remove_degenerate_faces(mesh_);
    note(Kind::degenerate_face, places, true);
    for (const auto v : mesh_.vertices())
      if (mesh_.is_isolated(v)) mesh_.remove_vertex(v);
  }

  Eigen::AlignedBox3d bounds_of_hole(Mesh::Halfedge_index border) const {
    Eigen::AlignedBox3d bounds;
    for (const auto h : halfedges_around_face(border, mesh_)) bounds.extend(vector_of(mesh_.point(mesh_.target(h))));
    return bounds;
  }

  void fill_holes() {
    constexpr double largest = 0.1;  // of the whole
    std::vector<Mesh::Halfedge_index> borders;
    pmp::extract_boundary_cycles(mesh_, std::back_inserter(borders));
    std::vector<Vec3> filled, open;
    for (const auto border : borders) {
      const Eigen::AlignedBox3d hole = bounds_of_hole(border);
      std::vector<Mesh::Face_index> patch;
      if (hole.diagonal().norm() <= largest * bounds_.diagonal().norm())
        pmp::triangulate_hole(mesh_, border, std::back_inserter(patch));
      (patch.empty() ? open : filled).push_back(hole.center());
    }
    note(Kind::hole, filled, true);
    note(Kind::hole, open, false);
  }

  /// Thinner than what vertices in one place are apart.
  void note_tiny_faces() {
    constexpr double thin = 1e-6;
    std::vector<Vec3> places;
    for (const auto face : mesh_.faces()) {
      std::array<Vec3, 3> at;
      std::size_t k = 0;
      for (const auto v : vertices_around_face(mesh_.halfedge(face), mesh_)) at[k++] = vector_of(mesh_.point(v));
      const double longest = std::max({(at[1] - at[0]).norm(), (at[2] - at[1]).norm(), (at[0] - at[2]).norm()});
      const double height = (at[1] - at[0]).cross(at[2] - at[0]).norm() / longest;
      if (height < thin * bounds_.diagonal().norm()) places.push_back(middle_of(face));
    }
    note(Kind::tiny_face, places, false);
  }

  bool note_self_intersections() {
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
    pmp::self_intersections(mesh_, std::back_inserter(pairs));
    std::vector<Vec3> places;
    for (const auto& [a, b] : pairs) places.push_back((middle_of(a) + middle_of(b)) / 2);
    note(Kind::self_intersection, places, false);
    return !pairs.empty();
  }

  /// Sheets that enclose rock; those around cavities do not count.
  void note_bodies() {
    const auto part = mesh_.add_property_map<Mesh::Face_index, std::size_t>("f:part", 0).first;
    const std::size_t count = pmp::connected_components(mesh_, part);
    std::vector<double> volume(count, 0);
    std::vector<Vec3> place(count, Vec3::Zero());
    for (const auto face : mesh_.faces()) {
      std::vector<Vec3> at;
      for (const auto v : vertices_around_face(mesh_.halfedge(face), mesh_))
        at.push_back(vector_of(mesh_.point(v)) - bounds_.center());
      volume[part[face]] += at[0].dot(at[1].cross(at[2]));
      place[part[face]] = middle_of(face);
    }
    std::vector<Vec3> bodies;
    for (std::size_t i = 0; i < count; ++i)
      if (volume[i] > 0) bodies.push_back(place[i]);
    if (bodies.size() > 1) note(Kind::several_bodies, bodies, true);
  }

  TriangleSolid surface() {
    mesh_.collect_garbage();
    TriangleSolid solid;
    for (const auto v : mesh_.vertices()) solid.vertices.push_back(vector_of(mesh_.point(v)));
    for (const auto face : mesh_.faces()) {
      std::array<int, 3> triangle{};
      std::size_t k = 0;
      for (const auto v : vertices_around_face(mesh_.halfedge(face), mesh_)) triangle[k++] = static_cast<int>(v.idx());
      solid.triangles.push_back(triangle);
    }
    return solid;
  }

  /// By comparison with the soup: turned here and there by whoever makes the surface look outwards.
  void note_turned_faces(const TriangleSolid& solid) {
    std::map<std::array<double, 3>, int> number;
    const auto key = [](const Vec3& p) { return std::array<double, 3>{p.x(), p.y(), p.z()}; };
    for (std::size_t i = 0; i < soup_.points.size(); ++i) number[key(soup_.points[i])] = static_cast<int>(i);
    const auto smallest_first = [](std::array<int, 3> t) {
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      return t;
    };
    std::set<std::array<int, 3>> now;
    for (auto triangle : solid.triangles) {
      for (int& v : triangle) v = number.at(key(solid.vertices[static_cast<std::size_t>(v)]));
      now.insert(smallest_first(triangle));
    }
    std::vector<Vec3> turned;
    for (const auto& [a, b, c] : soup_.triangles)
      if (now.contains(smallest_first({a, c, b}))) turned.push_back(soup_.points[static_cast<std::size_t>(a)]);
    note(Kind::inside_out, turned, true);
  }

  const TriangleSoup& soup_;
  Eigen::AlignedBox3d bounds_;
  Mesh mesh_;
  std::vector<SurfaceFinding> findings_;
};

}  // namespace

MendedSurface mended(const PolygonSoup& soup) {
  const TriangleSoup triangles = welded(soup);
  return Mender(triangles).mended();
}

}  // namespace talus
