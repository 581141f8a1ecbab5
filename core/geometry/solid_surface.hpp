#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "geometry/surface_finding.hpp"
#include "model/project.hpp"

namespace talus {

/// A solid as it comes, before anything is cut: scaled, turned, moved and less the project's origin.
struct SolidSurface {
  std::string name;
  std::vector<Vec3> vertices;                   ///< m
  std::vector<std::array<int, 3>> triangles;    ///< counter-clockwise seen from outside
  std::vector<std::array<int, 2>> edges;        ///< where the surface bends: what is drawn as lines
  double volume = 0;                            ///< m³; 0 where the surface is not closed
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();  ///< m, corners of the box around it
  bool closed = false;
  bool is_part = false;  ///< of a combined solid of the project: no body of its own
  std::vector<SurfaceFinding> findings;

  template <class Stream>
  void fields(Stream& stream) {
    stream(name, vertices, triangles, edges, volume, min, max, closed, is_part, findings);
  }
};

/// Every solid of the project, in its order, parts of combined ones too. What files hold is read and mended by the
/// mesher's process, which cancelling kills; a surface that is open or crosses itself comes back as it is, with a
/// finding for which `is_fatal`.
/// `folder`: where the project file lies. The shapes keep to the rules of a project.
/// Throws InputError at "solid NAME" or at the file for what cannot be read or combined, Cancelled when `progress`
/// says so.
std::vector<SolidSurface> solid_surfaces(const Project& project, const std::filesystem::path& folder,
                                         Progress& progress);

/// The same of one solid that is not combined of others, for the preview of a file. `origin`: the project's, m.
SolidSurface solid_surface(const Solid& solid, const Vec3& origin, const std::filesystem::path& folder,
                           Progress& progress);

}  // namespace talus
