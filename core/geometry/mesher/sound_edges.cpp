#include "geometry/mesher/sound_edges.hpp"

#include <gmsh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "geometry/mesher/facet.hpp"
#include "geometry/mesher/occ_volumes.hpp"

namespace talus {
namespace {

namespace occ = gmsh::model::occ;

InputError damaged(const MesherSolid& solid, const std::string& how) {
  return {solid.file_as_written, "is damaged: " + how, "export the solid again"};
}

/// Parameters of places along an edge, its ends and some between. None for edges that are a point.
std::vector<double> places_along(int edge) {
  constexpr int pieces = 4;
  std::string type;
  gmsh::model::getType(1, edge, type);
  if (type == "Unknown") return {};
  std::vector<double> low, high, places;
  gmsh::model::getParametrizationBounds(1, edge, low, high);
  for (int i = 0; i <= pieces; ++i) places.push_back(low.at(0) + (high.at(0) - low.at(0)) * i / pieces);
  return places;
}

/// m; the largest of these places. Without bounds where a face has no such place.
double apart(int edge, int face, const std::vector<double>& places) {
  std::vector<double> in_space, parameters, on_face;
  gmsh::model::getValue(1, edge, places, in_space);
  gmsh::model::reparametrizeOnSurface(1, edge, places, face, parameters);
  gmsh::model::getValue(2, face, parameters, on_face);
  if (on_face.size() != in_space.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i + 2 < in_space.size(); i += 3) {
    const double distance = (Vec3(&in_space[i]) - Vec3(&on_face[i])).norm();
    if (!(distance <= largest)) largest = distance;
  }
  return largest;
}

/// m; how far a corner at which the edge ends is from both of its ends.
double beside_ends(int edge, const std::vector<double>& places) {
  std::vector<double> ends, corner;
  gmsh::model::getValue(1, edge, {places.front(), places.back()}, ends);
  gmsh::vectorpair corners;
  gmsh::model::getBoundary({{1, edge}}, corners, false, false, false);
  double largest = 0;
  for (const auto& [dimension, tag] : corners) {
    gmsh::model::getValue(dimension, tag, {}, corner);
    const Vec3 at(corner.data());
    const double distance = std::min((at - Vec3(&ends[0])).norm(), (at - Vec3(&ends[3])).norm());
    if (!(distance <= largest)) largest = distance;
  }
  return largest;
}

}  // namespace

void check_edge_lengths(const MesherSolid& solid, const std::vector<int>& volumes) {
  static int looked_at = 0;                        // the largest number; this program has one model
  constexpr double farthest = 1e9, longest = 1e4;  // m; of the whole, for coasts have long edges
  const double whole = bounds_of(volumes).diagonal().norm();
  gmsh::vectorpair edges;
  occ::getEntities(edges, 1);
  for (const auto& [dimension, tag] : edges) {
    double length = 0;
    if (tag > looked_at) occ::getMass(dimension, tag, length);
    if (whole <= farthest && length <= longest * whole) continue;
    throw damaged(solid, "an edge of its solid has no end");
  }
  looked_at = occ::getMaxTag(1);
}

void check_edges_on_faces(const MesherSolid& solid, const std::vector<int>& volumes) {
  constexpr double allowed = 1e-2;
  const double whole = bounds_of(volumes).diagonal().norm();
  for (const int face : faces_of(volumes)) {
    gmsh::vectorpair edges;
    gmsh::model::getBoundary({{2, face}}, edges, false, false, false);
    for (const auto& [dimension, tag] : edges) {
      const auto places = places_along(tag);
      if (places.empty()) continue;
      if (!(apart(tag, face, places) <= allowed * whole))
        throw damaged(solid, "an edge of its solid does not lie on the faces beside it");
      if (!(beside_ends(tag, places) <= allowed * whole))
        throw damaged(solid, "an edge of its solid does not end at its corners");
    }
  }
}

}  // namespace talus
