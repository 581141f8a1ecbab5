#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "base/vector.hpp"

namespace talus {

/// What a face of a cut block lies on.
struct FacetOrigin {
  int plane = -1;  ///< index into the table of planes; −1: the face is curved
  int joint = -1;  ///< index into Project::joints; −1: on no cut
};

struct CutFacet {
  FacetOrigin origin;
  double area = 0;  ///< m²
};

/// A piece of a solid, or several pieces that are made one.
struct CutBlock {
  int solid = 0;
  std::vector<int> volume_tags;    ///< of gmsh's current model, a piece each; none where its solid is cut as cells
  std::vector<int> cells;          ///< of its solid, where that is cut as cells
  double volume = 0;               ///< m³
  Vec3 centroid = Vec3::Zero();    ///< relative to the model's origin
  Eigen::AlignedBox3d bounds;      ///< m, relative to the model's origin
  std::map<int, CutFacet> facets;  ///< its surface, by the face's gmsh tag; pieces of one solid share their faces

  /// m², of its surface.
  double area() const;
  /// Twice the volume over the area: a plate's thickness, half the width of a rod.
  double thickness() const;
};

/// By the centroid's x, then y, then z. Centroids that differ by rounding alone do not decide the order: it would not
/// repeat on another machine. `longest_side`: m, of the solid.
void sort_by_place(std::vector<CutBlock>& blocks, double longest_side);

/// m², of the faces that two blocks share.
double shared_area(const CutBlock& a, const CutBlock& b);

/// Makes `other` part of `block`: faces between the two are gone.
void join(CutBlock& block, const CutBlock& other);

/// A block as the project calls it.
struct NamedBlock {
  CutBlock shape;
  std::string name;
  int block_override = -1;  ///< index into MesherJob::overrides; −1: none
  double mesh_size = 0;     ///< m
};

}  // namespace talus
