#pragma once

#include <filesystem>
#include <optional>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "geometry/solid_surface.hpp"

namespace talus {

/// How a file of geometry is to be understood.
struct ImportChoices {
  bool asTerrain = false;                ///< rock below the surface, not a body of its own
  double scale = 1;                      ///< m per unit of the file; of bodies only
  enum class Up { z, y, x } up = Up::z;  ///< the axis of the file that points upwards; of bodies only
  std::optional<double> base;            ///< m; of terrain: empty, as deep below it as it is high
  double tolerance = 0;                  ///< m, of terrain
  Vec3 origin = Vec3::Zero();            ///< m, the project's
};

/// The solid that a file becomes, without a name. `base`, where it is empty, is zero.
Solid solidFrom(const std::filesystem::path& file, const ImportChoices& choices);

/// What came of reading a file: a surface, or why there is none.
struct SolidReading {
  std::optional<SolidSurface> surface;
  std::optional<InputError> problem;
  double base = 0;  ///< m, that was chosen or found for terrain
};
/// Throws Cancelled.
SolidReading readSolid(const std::filesystem::path& file, ImportChoices choices, Progress& progress);

/// An origin, in whole kilometres, that a solid which lies far from zero keeps more digits by; nothing for one that is
/// near.
std::optional<Vec3> localOrigin(const SolidSurface& surface);

}  // namespace talus
