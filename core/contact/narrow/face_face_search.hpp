#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/narrow/polygon_overlap.hpp"
#include "contact/narrow/separating_axis.hpp"
#include "contact/narrow/step_geometry.hpp"

namespace talus {

/// Coordinates in a plane. [m]
struct FlatPlane {
  const Vec3 &origin, &e1, &e2;
  Vec2 at(const Vec3& p) const {
    const Vec3 r = p - origin;
    return {r.dot(e1), r.dot(e2)};
  }
};

/// A face in the common plane, counter-clockwise there.
struct ProjectedFace {
  struct FlatFacet {
    int facet;
    std::array<Vec2, 3> points;
  };
  std::vector<Vec2> points;
  std::vector<int> nodes, sides;  ///< of each point; the edge from each to the next
  std::vector<double> lengths;    ///< m, from each point to the next, once the sides are measured
  std::vector<FlatFacet> facets;

  void project(const StepGeometry& step, int face, const FlatPlane& plane, bool seen_from_behind);
  void measure_sides();
  void project_facets(const StepGeometry& step, int face, const FlatPlane& plane);
  bool has_area(double least) const;
  /// No overlap with another face has more than this area. [m²]
  double most_overlap(const ProjectedFace& other) const;
  double distance(const Vec2& p, std::size_t side) const;  ///< m, inwards
  /// The node that p is nearer to than this fraction of the shorter side there; or −1.
  int node_at(const Vec2& p, double at_vertex) const;
  /// The edge that p is nearest to. Sides may go straight on in each other: not lines count, but where they end.
  int nearest_side(const Vec2& p) const;
  /// The facet that p lies on, and three barycentric coordinates there.
  int locate(const Vec2& p, double* at) const;
};

/// Face–face contact: faces with opposite normals touch at the corners of their overlap. Corners are merged where
/// only the mesh divides two overlaps.
class FaceFaceSearch {
 public:
  /// `facing`: those that look at each other.
  void find(const StepGeometry& step, std::span<const FacePair> facing, SeparatingAxis& axis, FoundPoints& found);

 private:
  struct Corner {
    std::uint64_t key;
    std::array<int, 2> facets;
    double weight;             // m²
    std::array<double, 6> at;  // barycentric coordinates on both facets
    Vec3 normal;
    Glide glide = Glide::halfway;
  };
  void overlap(const StepGeometry& step, const FacePair& pair, SeparatingAxis& axis, FoundPoints& found);
  void place_corners(const StepGeometry& step, std::size_t first);
  void name(const StepGeometry& step, const Vec2& place, Corner& corner, FoundPoints& found);
  void merge(const StepGeometry& step, FoundPoints& found);
  std::array<ProjectedFace, 2> flat_;
  OverlapPolygon polygon_;
  std::vector<Corner> corners_;
  std::array<std::vector<Vec3>, 2> places_;            // m, of the corners of one overlap, on both bodies
  std::vector<std::pair<std::uint64_t, int>> by_key_;  // keys and numbers of corners_, sorted
};

}  // namespace talus
