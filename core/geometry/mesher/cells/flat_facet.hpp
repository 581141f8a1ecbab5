#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "geometry/mesher/cells/divided_edges.hpp"

namespace talus {

/// A facet in coordinates of its own plane. Vertices on straight stretches of its outline are drawn in by next to
/// nothing, along a bow: no triangle then has three vertices of one stretch for its corners.
class FlatFacet {
 public:
  using Points = std::map<int, Eigen::Vector2d>;

  FlatFacet(const FacetOutline& outline, const SkinVertices& vertices);

  /// m, of the vertices of the outline.
  const Points& points() const { return points_; }
  Vec3 in_space(const Eigen::Vector2d& point) const { return origin_ + point.x() * u_ + point.y() * v_; }

  /// Points around and in the facet, as far from each other and from the outline's vertices as the size says.
  std::vector<Eigen::Vector2d> lattice(const SkinSize& size) const;

 private:
  bool is_straight(int vertex, const Points& flat) const;
  void draw_in(int start, int first, const Points& flat);

  Vec3 origin_, u_, v_;
  Points points_;
  std::multimap<int, int> outgoing_, incoming_;  ///< edges at each vertex
};

}  // namespace talus
