#include "geometry/mesher/surfaces/planar_faces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "base/units.hpp"

namespace talus {
namespace {

using Edge = std::array<int, 2>;

/// The triangle that runs along each directed edge.
std::map<Edge, int> owners_of(const TriangleSolid& solid) {
  std::map<Edge, int> owner;
  for (std::size_t i = 0; i < solid.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      owner[{solid.triangles[i][k], solid.triangles[i][(k + 1) % 3]}] = static_cast<int>(i);
  return owner;
}

/// Twice the area along the normal.
Vec3 area_of(const TriangleSolid& solid, std::size_t triangle) {
  const auto& t = solid.triangles[triangle];
  const Vec3& a = solid.vertices[static_cast<std::size_t>(t[0])];
  return (solid.vertices[static_cast<std::size_t>(t[1])] - a).cross(solid.vertices[static_cast<std::size_t>(t[2])] - a);
}

/// Grows the flat parts of a surface, from the largest triangle of each.
class FlatParts {
 public:
  explicit FlatParts(const TriangleSolid& solid)
      : solid_(solid), owner_(owners_of(solid)), part_(solid.triangles.size(), -1) {
    constexpr double flat = 1e-6;
    reach_ = flat * bounds_of(solid).diagonal().norm();
    std::vector<std::size_t> order(part_.size());
    std::vector<double> size;
    for (std::size_t i = 0; i < part_.size(); ++i) size.push_back(area_of(solid, i).norm());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
    for (const std::size_t seed : order)
      if (part_[seed] < 0) grow(seed);
  }

  int count() const { return count_; }
  int of(int triangle) const { return part_[static_cast<std::size_t>(triangle)]; }

  /// The part across a directed edge of the surface.
  int across(const Edge& edge) const { return of(owner_.at({edge[1], edge[0]})); }

 private:
  void grow(std::size_t seed) {
    const Vec3 normal = area_of(solid_, seed).normalized();
    const Vec3& origin = solid_.vertices[static_cast<std::size_t>(solid_.triangles[seed][0])];
    const auto fits = [&](std::size_t triangle) {
      const auto& t = solid_.triangles[triangle];
      return std::all_of(t.begin(), t.end(),
                         [&](int v) {
                           return std::abs(normal.dot(solid_.vertices[static_cast<std::size_t>(v)] - origin)) <= reach_;
                         }) &&
             normal.dot(area_of(solid_, triangle)) > 0;
    };
    std::vector<std::size_t> waiting{seed};
    part_[seed] = count_;
    while (!waiting.empty()) {
      const auto t = solid_.triangles[waiting.back()];
      waiting.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const auto beside = owner_.find({t[(k + 1) % 3], t[k]});
        if (beside == owner_.end()) continue;
        const auto neighbour = static_cast<std::size_t>(beside->second);
        if (part_[neighbour] >= 0 || !fits(neighbour)) continue;
        part_[neighbour] = count_;
        waiting.push_back(neighbour);
      }
    }
    ++count_;
  }

  const TriangleSolid& solid_;
  std::map<Edge, int> owner_;
  std::vector<int> part_;
  double reach_ = 0;
  int count_ = 0;
};

/// Loops of directed edges; where loops meet in a vertex the one that turns most to the left goes on, so that they stay
/// apart.
std::vector<std::vector<int>> loops_of(const TriangleSolid& solid, const std::vector<Edge>& edges, const Vec3& normal) {
  std::multimap<int, int> next;
  for (const auto& [a, b] : edges) next.emplace(a, b);
  const auto at = [&](int v) -> const Vec3& { return solid.vertices[static_cast<std::size_t>(v)]; };
  std::vector<std::vector<int>> loops;
  while (!next.empty()) {
    std::vector<int> loop{next.begin()->first};
    int before = -1;
    do {
      const int here = loop.back();
      const auto [begin, end] = next.equal_range(here);
      auto best = begin;
      double leftmost = -10;
      for (auto way = begin; before >= 0 && way != end; ++way) {
        const Vec3 in = at(here) - at(before), out = at(way->second) - at(here);
        const double angle = std::atan2(in.cross(out).dot(normal), in.dot(out));
        if (angle > leftmost) {
          leftmost = angle;
          best = way;
        }
      }
      before = here;
      loop.push_back(best->second);
      next.erase(best);
    } while (loop.back() != loop.front());
    loop.pop_back();
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// Twice the area along the normal; negative for a hole.
double area_of(const TriangleSolid& solid, const std::vector<int>& loop, const Vec3& normal) {
  const Vec3& origin = solid.vertices[static_cast<std::size_t>(loop.front())];
  double area = 0;
  for (std::size_t k = 1; k + 1 < loop.size(); ++k)
    area += normal.dot((solid.vertices[static_cast<std::size_t>(loop[k])] - origin)
                           .cross(solid.vertices[static_cast<std::size_t>(loop[k + 1])] - origin));
  return area;
}

}  // namespace

std::vector<PlanarFace> planar_faces(const TriangleSolid& solid) {
  const FlatParts parts(solid);
  std::vector<std::vector<Edge>> outline(static_cast<std::size_t>(parts.count()));
  std::vector<Vec3> normal(outline.size(), Vec3::Zero());
  std::vector<std::set<int>> meeting(solid.vertices.size());  // parts at each vertex
  for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
    const auto part = static_cast<std::size_t>(parts.of(static_cast<int>(i)));
    normal[part] += area_of(solid, i);
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge{solid.triangles[i][k], solid.triangles[i][(k + 1) % 3]};
      meeting[static_cast<std::size_t>(edge[0])].insert(parts.of(static_cast<int>(i)));
      if (parts.across(edge) != parts.of(static_cast<int>(i))) outline[part].push_back(edge);
    }
  }
  const double reach = 1e-6 * bounds_of(solid).diagonal().norm();
  std::vector<PlanarFace> faces;
  for (std::size_t part = 0; part < outline.size(); ++part) {
    PlanarFace face;
    for (const std::vector<int>& whole : loops_of(solid, outline[part], normal[part].normalized())) {
      std::vector<int> loop;
      for (std::size_t k = 0; k < whole.size(); ++k) {
        const auto at = [&](std::size_t i) -> const Vec3& {
          return solid.vertices[static_cast<std::size_t>(whole[i % whole.size()])];
        };
        const Vec3 along = at(k + 1) - at(k + whole.size() - 1), arm = at(k) - at(k + whole.size() - 1);
        const bool straight = arm.dot(along) > 0 && along.cross(arm).norm() <= reach * along.norm();
        if (!straight || meeting[static_cast<std::size_t>(whole[k])].size() > 2) loop.push_back(whole[k]);
      }
      if (loop.size() >= 3) face.loops.push_back(std::move(loop));
    }
    // The outline is the one loop that turns as the surface does.
    std::stable_sort(face.loops.begin(), face.loops.end(), [&](const auto& a, const auto& b) {
      return area_of(solid, a, normal[part]) > area_of(solid, b, normal[part]);
    });
    if (!face.loops.empty()) faces.push_back(std::move(face));
  }
  return faces;
}

std::vector<Edge> feature_edges(const TriangleSolid& solid) {
  const double smooth = std::cos(radians(20.0));
  const std::map<Edge, int> owner = owners_of(solid);
  std::vector<Edge> edges;
  for (const auto& [edge, triangle] : owner) {
    const auto beside = owner.find({edge[1], edge[0]});
    const Vec3 normal = area_of(solid, static_cast<std::size_t>(triangle)).normalized();
    const bool ends = beside == owner.end();
    if (!ends && edge[0] > edge[1]) continue;  // each once
    if (ends || normal.dot(area_of(solid, static_cast<std::size_t>(beside->second)).normalized()) < smooth)
      edges.push_back({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])});
  }
  return edges;
}

std::vector<int> connected_parts(const TriangleSolid& solid) {
  const std::map<Edge, int> owner = owners_of(solid);
  std::vector<int> part(solid.triangles.size(), -1);
  int count = 0;
  for (std::size_t seed = 0; seed < part.size(); ++seed) {
    if (part[seed] >= 0) continue;
    std::vector<std::size_t> waiting{seed};
    part[seed] = count;
    while (!waiting.empty()) {
      const auto t = solid.triangles[waiting.back()];
      waiting.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const auto beside = owner.find({t[(k + 1) % 3], t[k]});
        if (beside == owner.end() || part[static_cast<std::size_t>(beside->second)] >= 0) continue;
        part[static_cast<std::size_t>(beside->second)] = count;
        waiting.push_back(static_cast<std::size_t>(beside->second));
      }
    }
    ++count;
  }
  return part;
}

}  // namespace talus
