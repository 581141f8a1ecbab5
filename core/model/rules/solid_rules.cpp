#include "model/rules/solid_rules.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>

#include "model/number_text.hpp"
#include "model/polyhedron.hpp"
#include "model/require.hpp"
#include "model/suggestion.hpp"

namespace talus {
namespace {

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

void check_shape(const BoxShape& box, const Place& solid) { check(box, solid / "box"); }

void check_shape(const PolyhedronShape& shape, const Place& solid) {
  stop_at_first_broken([&] { validate_polyhedron(shape, solid / "polyhedron"); });
}

void check_shape(const FileShape& shape, const Place& solid) {
  const Place place = solid / "file";
  require(!shape.path.empty(), place, "the file name is empty", "name a file beside the project");
  require(is_solid_file(shape.path), place, "solids are not read from '" + ending_of(shape.path) + "' files",
          "export the solid as STEP, IGES, BREP, STL, OBJ, PLY or MSH");
  require_positive(shape.scale, solid / "scale", "scale", "metres per unit of the file");
}

void check_shape(const TerrainShape& shape, const Place& solid) {
  const Place place = solid / "terrain";
  require(!shape.path.empty(), place / "file", "the file name is empty", "name a file beside the project");
  require(is_terrain_file(shape.path), place / "file", "terrain is not read from '" + ending_of(shape.path) + "' files",
          "give a grid of heights (.asc, .tif), points (.xyz, .csv) or triangles (.stl, .obj, .ply)");
  require_finite(shape.base, place / "base");
  require_not_negative(shape.tolerance, place / "tolerance", "tolerance", "m");
}

void check_shape(const CylinderShape& shape, const Place& solid) {
  const Place place = solid / "cylinder";
  require_finite(shape.from, place / "from");
  require_finite(shape.to, place / "to");
  require(shape.from != shape.to, place / "to", "the cylinder has no length", "give its two ends apart");
  require_positive(shape.radius, place / "radius", "radius", "m");
  require(shape.sides >= 3 && shape.sides <= 1000, place / "sides",
          "a cylinder has 3 to 1000 sides, not " + std::to_string(shape.sides), "24 looks round");
}

using Corner = std::array<double, 2>;

/// Twice the area of the triangle, positive where it turns left.
double turn(const Corner& a, const Corner& b, const Corner& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// But for rounding: a rib that thin is cut, and cannot be meshed.
bool lies_on(const Corner& a, const Corner& b, const Corner& p) {
  constexpr double rounding = 1e-9;  // of the side's length
  const double x = b[0] - a[0], y = b[1] - a[1], squared_length = x * x + y * y;
  const double along = (p[0] - a[0]) * x + (p[1] - a[1]) * y;
  const double share = squared_length > 0 ? std::clamp(along / squared_length, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - share * x, p[1] - a[1] - share * y) <= rounding * std::sqrt(squared_length);
}

bool touch(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (((abc > 0 && abd < 0) || (abc < 0 && abd > 0)) && ((cda > 0 && cdb < 0) || (cda < 0 && cdb > 0))) return true;
  return lies_on(a, b, c) || lies_on(a, b, d) || lies_on(c, d, a) || lies_on(c, d, b);
}

/// Sides that are no neighbours must not touch.
bool crosses_itself(const std::vector<Corner>& points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k == n - 1) continue;
      if (touch(points[i], points[i + 1], points[k], points[(k + 1) % n])) return true;
    }
  }
  return false;
}

void check_shape(const SectionShape& shape, const Place& solid) {
  const Place place = solid / "section";
  for (std::size_t i = 0; i < shape.points.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) require_finite(shape.points[i][k], place / "points" / i / k);
  require(shape.points.size() >= 3, place / "points", "a section has at least three corners", "add corners");
  double area = 0;
  for (std::size_t i = 1; i + 1 < shape.points.size(); ++i)
    area += turn(shape.points[0], shape.points[i], shape.points[i + 1]);
  require(area != 0, place / "points", "the section has no area", "give it corners that are not in one line");
  require(!crosses_itself(shape.points), place / "points", "the section's outline touches or crosses itself",
          "list its corners in order around it, the first once");
  require_finite(shape.origin, place / "origin");
  require_finite(shape.azimuth, place / "azimuth");
  require_positive(shape.width, place / "width", "width", "m");
}

/// Its parts are looked at once they are all named: check_combined_solids.
void check_shape(const CombinedShape&, const Place&) {}

}  // namespace

bool is_solid_file(const std::string& path) {
  static const std::set<std::string> endings{".step", ".stp", ".iges", ".igs", ".brep", ".stl", ".obj", ".ply", ".msh"};
  return endings.contains(ending_of(path));
}

bool is_terrain_file(const std::string& path) {
  static const std::set<std::string> endings{".asc", ".tif", ".tiff", ".xyz", ".csv", ".txt", ".stl", ".obj", ".ply"};
  return endings.contains(ending_of(path));
}

void check(const BoxShape& box, const Place& place) {
  require_finite(box.min, place / "min");
  require_finite(box.max, place / "max");
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    require(box.min[axis] < box.max[axis], place / "max" / i,
            "must be greater than min: " + number_text(box.max[axis]) + " against " + number_text(box.min[axis]),
            "swap the two corners' values or give the box a thickness");
  }
}

void check(const Solid& solid, const Place& place) {
  std::visit([&](const auto& shape) { check_shape(shape, place); }, solid.shape);
  if (solid.mesh_size) require_positive(*solid.mesh_size, place / "mesh_size", "mesh size", "m");
  require_finite(solid.move, place / "move");
  if (!solid.turn) return;
  require_finite(solid.turn->axis, place / "turn" / "axis");
  require(!solid.turn->axis.isZero(), place / "turn" / "axis", "the axis has no direction",
          "give [0, 0, 1] for upright");
  require_finite(solid.turn->angle, place / "turn" / "angle");
  require_finite(solid.turn->about, place / "turn" / "about");
}

void check_combined_solids(const Project& project) {
  std::set<std::string> before, used;
  for (std::size_t i = 0; i < project.solids.size(); ++i) {
    const Solid& solid = project.solids[i];
    if (const auto* combined = std::get_if<CombinedShape>(&solid.shape)) {
      const Place parts = Place() / "solids" / i / "combine" / "solids";
      require(combined->solids.size() >= 2, parts, "there is nothing to combine", "name two solids or more");
      for (std::size_t k = 0; k < combined->solids.size(); ++k) {
        const std::string& part = combined->solids[k];
        // What is made comes after what it is made of: there is no circle then.
        require(before.contains(part), parts / k, "'" + part + "' does not stand before the solid that is made of it",
                "move it up in the list of solids, or name another one");
        require(used.insert(part).second, parts / k, "'" + part + "' is a part of a solid already",
                "copy it under another name, or name another one");
      }
    }
    before.insert(solid.name);
  }
}

}  // namespace talus
