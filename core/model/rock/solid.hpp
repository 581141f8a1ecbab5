#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/vector.hpp"
#include "model/rock/body_kind.hpp"

/// The bodies of rock before they are cut: their shapes, and where they lie.
namespace talus {

struct BoxShape {
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();
  bool operator==(const BoxShape&) const = default;
};
/// Faces are polygons of vertex numbers, counter-clockwise seen from outside.
struct PolyhedronShape {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;
  bool operator==(const PolyhedronShape&) const = default;
};
/// `path` as written in the project file, relative to its folder; the ending names the format (`is_solid_file`).
struct FileShape {
  std::string path;
  double scale = 1;  ///< metres per unit of the file
  bool operator==(const FileShape&) const = default;
};
/// Rock below a surface, down to a level: `path` is a grid of heights, points, or triangles (`is_terrain_file`).
struct TerrainShape {
  std::string path;
  double base = 0;       ///< m, z of the flat underside, below all of the surface
  double tolerance = 0;  ///< m, how far the thinned surface may lie from what the file has; 0 keeps every point
  bool operator==(const TerrainShape&) const = default;
};
/// A prism of `sides` around the axis, whose corners lie on the circle: a tunnel, a shaft, a bolt's hole.
struct CylinderShape {
  Vec3 from = Vec3::Zero(), to = Vec3::UnitZ();  ///< m, ends of the axis
  double radius = 1;                             ///< m
  int sides = 24;
  bool operator==(const CylinderShape&) const = default;
};
/// A closed vertical section that is extruded to both sides: benches, a dam, the rock around a tunnel.
struct SectionShape {
  std::vector<std::array<double, 2>> points;  ///< m: distance along the section, and height above `origin`
  Vec3 origin = Vec3::Zero();                 ///< m, where both are zero
  double azimuth = 90;                        ///< degrees clockwise from north, the way in which the distance grows
  double width = 1;                           ///< m across the section, half of it to each side
  bool operator==(const SectionShape&) const = default;
};
enum class CombineOperation { unite, subtract, intersect };

/// The word the project file uses.
constexpr std::string_view to_string(CombineOperation operation) {
  switch (operation) {
    case CombineOperation::subtract:
      return "subtract";
    case CombineOperation::intersect:
      return "intersect";
    case CombineOperation::unite:
      break;
  }
  return "unite";
}

/// Made of other solids of the project, which are no bodies of their own then. The others are subtracted from the
/// first.
struct CombinedShape {
  CombineOperation operation = CombineOperation::unite;
  std::vector<std::string> solids;  ///< names
  bool operator==(const CombinedShape&) const = default;
};

using SolidShape =
    std::variant<BoxShape, PolyhedronShape, FileShape, TerrainShape, CylinderShape, SectionShape, CombinedShape>;

/// A rotation by the right hand about an axis through a point.
struct Turn {
  Vec3 axis = Vec3::UnitZ();  ///< of any length
  double angle = 0;           ///< degrees
  Vec3 about = Vec3::Zero();  ///< m
  bool operator==(const Turn&) const = default;
};

struct Solid {
  std::string name;
  SolidShape shape;
  std::string material;
  BodyKind body = BodyKind::tetrahedra;
  std::optional<double> mesh_size;  ///< m; when absent, a tenth of the longest side; rigid and affine blocks need none
  std::optional<Turn> turn{};       ///< of the shape, before it is moved
  Vec3 move = Vec3::Zero();         ///< m
  bool operator==(const Solid&) const = default;
};

}  // namespace talus
