#include "contact/passage/widest_gap.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {
namespace {

/// sin² of the angle of two edges that are as good as parallel: the direction across both is rounding, and what it
/// would say the normals of faces say.
constexpr double parallel = 1e-12;

/// Along the normals of the faces of `piece`; `sign`: 1 if it is the first of the two.
void look_along_normals(const PlacedPiece& piece, const PlacedPiece& other, double sign, double enough, Gap& widest) {
  for (std::size_t face = 0; face < piece.normals.size() && widest.width <= enough; ++face) {
    const Vec3& normal = piece.normals[face];
    const Vec3& origin = piece.corners[piece.shape->faces[face][0]];
    const double width = normal.dot(other.farthest(-normal) - origin);
    if (width > widest.width) widest = {sign * normal, width};
  }
}

/// Of two edges whose normals are opposite somewhere no corner lies nearer along the direction across both.
void look_across_edges(const PlacedPiece& first, const PlacedPiece& second, double enough, Gap& widest) {
  for (const ConvexShape::Edge& a : first.shape->edges) {
    const Vec3 &origin = first.corners[a.corners[0]], u = first.corners[a.corners[1]] - origin;
    const Vec3 &a0 = first.normals[a.faces[0]], &a1 = first.normals[a.faces[1]];
    for (const ConvexShape::Edge& b : second.shape->edges) {
      const Vec3 &base = second.corners[b.corners[0]], w = second.corners[b.corners[1]] - base;
      const Vec3 &b0 = second.normals[b.faces[0]], &b1 = second.normals[b.faces[1]];
      // The arcs of normals cross: each has its ends on both sides of the other's plane, and both on one hemisphere.
      if (u.dot(b0) * u.dot(b1) > 0 || w.dot(a0) * w.dot(a1) > 0) continue;
      Vec3 across = u.cross(w);
      const double squared = across.squaredNorm();
      if (!(squared > parallel * u.squaredNorm() * w.squaredNorm())) continue;
      if (across.dot(a0 + a1) < 0) across = -across;
      if (across.dot(b0 + b1) > 0) continue;
      const double width = across.dot(base - origin) / std::sqrt(squared);
      if (width > widest.width) widest = {across / std::sqrt(squared), width};
      if (widest.width > enough) return;
    }
  }
}

}  // namespace

void PlacedPiece::find_normals() {
  normals.clear();
  for (const auto& [a, b, c] : shape->faces)
    normals.push_back((corners[b] - corners[a]).cross(corners[c] - corners[a]).normalized());
}

const Vec3& PlacedPiece::farthest(const Vec3& direction) const {
  const Vec3* best = &corners.front();
  double most = direction.dot(*best);
  for (const Vec3& corner : corners)
    if (const double along = direction.dot(corner); along > most) {
      most = along;
      best = &corner;
    }
  return *best;
}

double gap_along(const Vec3& direction, const PlacedPiece& first, const PlacedPiece& second) {
  return direction.dot(second.farthest(-direction) - first.farthest(direction));
}

const Vec3& deepest_corner(const Vec3& direction, const PlacedPiece& first, const PlacedPiece& second) {
  const auto extent = [&](const PlacedPiece& piece) {
    return direction.dot(piece.farthest(direction) - piece.farthest(-direction));
  };
  return extent(first) < extent(second) ? first.farthest(direction) : second.farthest(-direction);
}

Gap widest_gap(const PlacedPiece& first, const PlacedPiece& second, double enough) {
  Gap widest{Vec3::UnitX(), -std::numeric_limits<double>::infinity()};
  look_along_normals(first, second, 1, enough, widest);
  look_along_normals(second, first, -1, enough, widest);
  if (widest.width <= enough) look_across_edges(first, second, enough, widest);
  return widest;
}

}  // namespace talus
