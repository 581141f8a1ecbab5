#pragma once

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// Formats that hold closed bodies, by the ending of a file's name in small or capital letters: STEP, IGES and BREP
/// through OpenCASCADE; STL, OBJ, PLY and MSH as triangles.
bool is_solid_file(const std::string& path);

/// Formats that hold a surface of the ground: grids of heights (.asc, .tif), points (.xyz, .csv), triangles.
bool is_terrain_file(const std::string& path);

/// The rules of a box and of a solid, at `place` in the project. Each throws InputError for the first that is broken.
void check(const BoxShape& box, const Place& place);
void check(const Solid& solid, const Place& place);

/// Solids that are made of others are made of two or more, each of which stands before them and is a part once. Throws
/// InputError for the first that is not.
void check_combined_solids(const Project& project);

}  // namespace talus
