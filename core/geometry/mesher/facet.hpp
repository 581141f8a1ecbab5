#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "geometry/mesher/plane.hpp"

namespace talus {

/// A face of gmsh's current model: points along its outline, and its plane when it is flat.
struct Facet {
  int tag = 0;
  std::vector<Vec3> outline;
  std::optional<Plane> plane;
};

/// The synchronised face with this gmsh tag.
Facet read_facet(int tag);

/// m², of a synchronised face.
double area_of(int tag);

/// The faces that bound a volume, or several volumes, each once.
std::vector<int> faces_of(const std::vector<int>& volumes);

/// A plane that runs at less than 0.1° to a facet and comes within `reach` of its outline lies on it: cutting along
/// both would leave a splinter.
bool lies_on(const Plane& plane, const Facet& facet, double reach);

/// m, of a volume; wider than it by OpenCASCADE's tolerance.
Eigen::AlignedBox3d bounds_of_volume(int tag);

struct Bulk {
  double volume = 0;  ///< m³
  Vec3 centroid = Vec3::Zero();
};

struct Measure : Bulk {
  double area = 0;  ///< m²

  /// Twice the volume over the area: a plate's thickness, half the width of a rod.
  double thickness() const { return area > 0 ? 2 * volume / area : 0; }
};

/// Of a synchronised volume; the measure, for which all its faces are measured, takes longer.
Bulk bulk_of_volume(int tag);
Measure measure_volume(int tag);

}  // namespace talus
