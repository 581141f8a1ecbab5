#pragma once

#include <string>
#include <vector>

#include "geometry/mesher/blocks/kept_blocks.hpp"

namespace talus {

/// "(1, 2, 3)"
std::string coordinates(const Vec3& point);

/// Drops blocks thinner or smaller than the project allows, or makes each part of the neighbour that it shares most of
/// its surface with (dropped where it has none), the thinnest first; tells what became of them. Throws SplintersFound,
/// with all of them, where the project refuses splinters.
std::vector<MesherSplinter> treat_splinters(std::vector<NamedBlock>& blocks, const MesherJob& job,
                                            const ImportedModel& model);

}  // namespace talus
