#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/rock/solid.hpp"

namespace talus {

/// The path of the file that the shape is read from, as the project has it; null where it is not read from any.
const std::string* file_of(const SolidShape& shape);
std::string* file_of(SolidShape& shape);

/// Box, polyhedron, cylinder or section as plane faces, turned and moved as the solid is; nothing for shapes that only
/// reading files or combining solids can tell. The shape keeps to the rules of a project.
std::optional<PolyhedronShape> polyhedron_of(const Solid& solid);

/// Where a point of the solid's shape lies once the solid is turned and moved.
Vec3 placed(const Solid& solid, const Vec3& point);

/// Corners of the box around all solids whose shape the project itself tells; nothing where there is none.
std::optional<BoxShape> extent_of(const std::vector<Solid>& solids);

}  // namespace talus
