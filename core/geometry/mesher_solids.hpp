#pragma once

#include <filesystem>
#include <vector>

#include "geometry/mesher_job.hpp"

namespace talus {

/// What the mesher has to know of the solids, in their order. `origin`: the project's; `folder`: where its file lies.
/// Throws InputError where a solid's file is missing.
std::vector<MesherSolid> mesher_solids(const std::vector<Solid>& solids, const Vec3& origin,
                                       const std::filesystem::path& folder);

}  // namespace talus
