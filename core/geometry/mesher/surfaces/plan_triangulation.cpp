#include "geometry/mesher/surfaces/plan_triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <queue>
#include <set>
#include <utility>

namespace talus {

/// What a face has to represent: points over it that are no corners, and the one farthest from it.
struct BurdenOfFace {
  std::vector<int> points;
  int worst = -1;
  double error = 0;  ///< m, of the worst
  int depth = -1;    ///< how many kept edges lie between it and the outside; −1: not known
};

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PlanPoint = Kernel::Point_2;

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<BurdenOfFace, Kernel,
                                                           CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_tag>;
using Face = Triangulation::Face_handle;

PlanPoint in_plan(const Vec3& point) { return {point.x(), point.y()}; }

}  // namespace

struct PlanTriangulation::Inside {
  explicit Inside(const std::vector<Vec3>& all)
      : points(all), corner(all.size(), Triangulation::Vertex_handle()), face_of(all.size(), Face()) {}

  const Vec3& at(int point) const { return points[static_cast<std::size_t>(point)]; }
  bool is_corner(int point) const { return corner[static_cast<std::size_t>(point)] != nullptr; }

  Triangulation::Vertex_handle add(int point, Face hint) {
    const auto vertex = triangulation.insert(in_plan(at(point)), hint);
    vertex->info() = point;
    return corner[static_cast<std::size_t>(point)] = vertex;
  }

  /// The finite face over which a point lies, or beside which, just outside the hull.
  Face face_at(int point, Face hint) const {
    const Face face = triangulation.locate(in_plan(at(point)), hint);
    return triangulation.is_infinite(face) ? face->neighbor(face->index(triangulation.infinite_vertex())) : face;
  }

  /// Vertical distance of a point to the plane of a face, m.
  double error_of(int point, Face face) const {
    const Vec3 &a = at(face->vertex(0)->info()), &b = at(face->vertex(1)->info()), &c = at(face->vertex(2)->info());
    const Vec3 normal = (b - a).cross(c - a);
    return normal.z() > 0 ? std::abs(normal.dot(at(point) - a)) / normal.z() : 0;
  }

  void burden(int point, Face hint) {
    const Face face = face_at(point, hint);
    const double error = error_of(point, face);
    BurdenOfFace& load = face->info();
    load.points.push_back(point);
    face_of[static_cast<std::size_t>(point)] = face;
    if (load.worst >= 0 && error <= load.error) return;
    load.worst = point;
    load.error = error;
  }

  void queue_up(Face face) {
    if (!triangulation.is_infinite(face) && face->info().worst >= 0)
      worst_points.emplace(face->info().error, face->info().worst);
  }

  /// The points of the faces that make way go to those around the new corner.
  void make_corner(int point) {
    const Face before = face_of[static_cast<std::size_t>(point)];
    std::vector<Face> conflicts;
    triangulation.get_conflicts(in_plan(at(point)), std::back_inserter(conflicts), before);
    std::vector<int> displaced;
    for (const Face face : conflicts) {
      displaced.insert(displaced.end(), face->info().points.begin(), face->info().points.end());
      face->info() = {};
    }
    const auto vertex = add(point, before);
    auto face = triangulation.incident_faces(vertex);
    const auto first = face;
    do face->info() = {};
    while (++face != first);
    for (const int other : displaced)
      if (other != point) burden(other, vertex->face());
    do queue_up(face);
    while (++face != first);
  }

  void burden_all() {
    for (const Face face : triangulation.finite_face_handles()) face->info() = {};
    Face hint = triangulation.finite_faces_begin();
    for (int point = 0; point < static_cast<int>(points.size()); ++point) {
      if (is_corner(point)) continue;
      burden(point, hint);
      hint = face_of[static_cast<std::size_t>(point)];
    }
    for (const Face face : triangulation.finite_face_handles()) queue_up(face);
  }

  /// Whether any point had to be taken.
  bool take_the_worst(double tolerance) {
    bool taken = false;
    while (!worst_points.empty()) {
      const auto [error, point] = worst_points.top();
      worst_points.pop();
      if (error <= tolerance) break;
      const BurdenOfFace& load = face_of[static_cast<std::size_t>(point)]->info();
      if (is_corner(point) || load.worst != point || load.error != error) continue;  // its face has changed since
      make_corner(point);
      taken = true;
    }
    worst_points = {};
    return taken;
  }

  std::array<int, 3> corners_of(Face face) const {
    return {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
  }

  const std::vector<Vec3>& points;
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> corner;
  std::vector<Face> face_of;
  std::priority_queue<std::pair<double, int>> worst_points;
};

PlanTriangulation::PlanTriangulation(const std::vector<Vec3>& points) : inside_(std::make_unique<Inside>(points)) {}

PlanTriangulation::~PlanTriangulation() = default;

void PlanTriangulation::take(const std::vector<int>& points) {
  std::vector<PlanPoint> places;
  for (const int point : points) places.push_back(in_plan(inside_->at(point)));
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  using Places = CGAL::Pointer_property_map<PlanPoint>::type;
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Places>(CGAL::make_property_map(places)));
  Face hint;
  for (const std::size_t i : order)
    if (!inside_->is_corner(points[i])) hint = inside_->add(points[i], hint)->face();
}

int PlanTriangulation::keep_edges(const std::vector<std::array<int, 2>>& edges) {
  for (const auto& [a, b] : edges) {
    try {
      inside_->triangulation.insert_constraint(inside_->corner[static_cast<std::size_t>(a)],
                                               inside_->corner[static_cast<std::size_t>(b)]);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return a;
    }
  }
  return -1;
}

void PlanTriangulation::refine(double tolerance) {
  // Once is enough but for rounding at the rim; that none is farther is seen by looking again.
  do inside_->burden_all();
  while (inside_->take_the_worst(tolerance));
}

std::vector<std::array<int, 3>> PlanTriangulation::triangles(double thin) const {
  const Triangulation& all = inside_->triangulation;
  std::set<Face> left_out;
  std::vector<Triangulation::Edge> rim;  // seen from the face that is still there
  std::set<int> on_rim;
  for (auto edge = all.finite_edges_begin(); edge != all.finite_edges_end(); ++edge) {
    const auto mirrored = all.mirror_edge(*edge);
    if (!all.is_infinite(edge->first) && !all.is_infinite(mirrored.first)) continue;
    rim.push_back(all.is_infinite(edge->first) ? mirrored : *edge);
    for (const int k : {1, 2}) on_rim.insert(rim.back().first->vertex((rim.back().second + k) % 3)->info());
  }
  while (!rim.empty()) {
    const auto [face, opposite] = rim.back();
    rim.pop_back();
    const int apex = face->vertex(opposite)->info();
    const Vec3 &a = inside_->at(face->vertex(Triangulation::ccw(opposite))->info()),
               &b = inside_->at(face->vertex(Triangulation::cw(opposite))->info()), &c = inside_->at(apex);
    const Vec3 along = b - a, across = c - a;
    const double height = std::abs(along.x() * across.y() - along.y() * across.x()) / std::hypot(along.x(), along.y());
    if (height >= thin || !on_rim.insert(apex).second || !left_out.insert(face).second) continue;
    for (const int k : {1, 2}) {
      const auto behind = all.mirror_edge(Triangulation::Edge(face, (opposite + k) % 3));
      if (!all.is_infinite(behind.first)) rim.push_back(behind);
    }
  }
  std::vector<std::array<int, 3>> triangles;
  for (const Face face : all.finite_face_handles())
    if (!left_out.contains(face)) triangles.push_back(inside_->corners_of(face));
  return triangles;
}

std::vector<std::array<int, 3>> PlanTriangulation::triangles_within_edges() const {
  const Triangulation& all = inside_->triangulation;
  for (const Face face : all.all_face_handles()) face->info().depth = -1;
  std::vector<Face> waiting{all.infinite_face()}, across;
  for (int depth = 0; !waiting.empty(); ++depth, waiting.swap(across), across.clear()) {
    while (!waiting.empty()) {
      const Face face = waiting.back();
      waiting.pop_back();
      if (face->info().depth >= 0) continue;
      face->info().depth = depth;
      for (int k = 0; k < 3; ++k) (face->is_constrained(k) ? across : waiting).push_back(face->neighbor(k));
    }
  }
  std::vector<std::array<int, 3>> triangles;
  for (const Face face : all.finite_face_handles())
    if (face->info().depth % 2 == 1) triangles.push_back(inside_->corners_of(face));
  return triangles;
}

std::vector<int> hull_in_plan(const std::vector<Vec3>& points, double thin) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int point) -> const Vec3& { return points[static_cast<std::size_t>(point)]; };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::pair(at(a).x(), at(a).y()) < std::pair(at(b).x(), at(b).y()); });
  // Andrew's monotone chain: the lower side, then back along the upper one.
  std::vector<int> hull;
  const auto run = [&](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto point = begin; point != end; ++point) {
      while (hull.size() >= start + 2 && CGAL::orientation(in_plan(at(hull[hull.size() - 2])), in_plan(at(hull.back())),
                                                           in_plan(at(*point))) != CGAL::LEFT_TURN)
        hull.pop_back();
      hull.push_back(*point);
    }
    hull.pop_back();  // the next run begins with it
  };
  run(order.begin(), order.end());
  run(order.rbegin(), order.rend());
  std::vector<int> corners;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec3 &before = at(corners.empty() ? hull.back() : corners.back()), &after = at(hull[(i + 1) % hull.size()]);
    const Vec3 chord = after - before, arm = at(hull[i]) - before;
    const double length = std::hypot(chord.x(), chord.y());
    if (length > 0 && std::abs(chord.x() * arm.y() - chord.y() * arm.x()) / length > thin) corners.push_back(hull[i]);
  }
  return corners;
}

}  // namespace talus
