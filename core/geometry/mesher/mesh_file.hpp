#pragma once

#include <string>

#include "geometry/mesher/surfaces/polygon_soup.hpp"

namespace talus {

/// The skin of a gmsh mesh file: of its tetrahedra where it has any, else its triangles and quadrangles. `as_written`
/// names the file. Throws InputError when it has neither.
PolygonSoup read_mesh(const std::string& path, const std::string& as_written);

}  // namespace talus
