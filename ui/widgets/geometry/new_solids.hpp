#pragma once

#include <optional>
#include <string>

#include "model/project.hpp"

namespace talus {

/// Shapes that a solid can be begun with; they are changed in its form, or by hand, afterwards.
enum class NewShape { box, bench, polyhedron, tunnel };

/// The project with one more solid, and with a rock where it has no material yet. It is as large as suits the rock that
/// is there (`extent`, m; empty: 10 m): a tunnel leads through the middle of it, from south to north, the others stand
/// beside it in the east.
Project with_new_solid(Project project, NewShape shape, const std::optional<BoxShape>& extent);

}  // namespace talus
