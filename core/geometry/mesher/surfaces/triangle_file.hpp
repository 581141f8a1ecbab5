#pragma once

#include <string>

#include "geometry/mesher/surfaces/polygon_soup.hpp"

namespace talus {

/// The polygons of an STL, OBJ or PLY file, text or binary, as its ending says, in the file's own units. `as_written`
/// names the file. Throws InputError when it has none, ends too early or has numbers that are none.
PolygonSoup read_polygons(const std::string& path, const std::string& as_written);

/// The ending of a path in small letters, with its point.
std::string ending_of(const std::string& path);

}  // namespace talus
