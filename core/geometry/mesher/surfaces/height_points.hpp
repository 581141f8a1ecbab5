#pragma once

#include <string>
#include <vector>

#include "base/vector.hpp"
#include "geometry/surface_finding.hpp"

namespace talus {

/// Points of a terrain, as its file has them but for the origin.
struct HeightPoints {
  std::vector<Vec3> points;  ///< m
  std::vector<SurfaceFinding> findings;
};

/// The centres of the cells of a grid of heights (ESRI ASCII, GeoTIFF), less `origin`; cells without a height are left
/// out. Throws InputError at `as_written` when the file is none, is a picture, lies in degrees or is too large.
HeightPoints read_grid(const std::string& path, const std::string& as_written, const Vec3& origin);

/// A text of points, three numbers a line between blanks, commas, semicolons or tabs, less `origin`. Lines before the
/// first number are its heading: where it names x, y and z, or easting, northing and elevation, their columns are
/// taken, else the first three. Throws InputError at "FILE:LINE".
HeightPoints read_points(const std::string& path, const std::string& as_written, const Vec3& origin);

}  // namespace talus
