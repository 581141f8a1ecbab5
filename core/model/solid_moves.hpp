#pragma once

#include <vector>

#include "model/project.hpp"

/// What is done with solids as a whole. Each gives the solid, or the project, as it is afterwards.
namespace talus {

Solid moved(Solid solid, const Vec3& by);

/// Turned on, after what turns it already: both become one rotation.
Solid turned(Solid solid, const Turn& by);

/// Enlarged `factor` times, above 0, about a point: the coordinates of shapes that have some, the scale of a file.
/// `origin`: the project's. Throws InputError for shapes whose size is another's: terrain and combined solids.
Solid scaled(Solid solid, double factor, const Vec3& about, const Vec3& origin);

/// `solid`, a number in the project, `count` times more, behind it: each a further `step` away, under names of their
/// own.
Project with_copies(Project project, int solid, int count, const Vec3& step);

/// With one more solid, made of some by their numbers, at the end of the list: the first of them says its material,
/// body and mesh size. Throws InputError where they are fewer than two, or one is a part of another solid already.
Project with_combined(Project project, CombineOperation operation, const std::vector<int>& solids);

/// `stem`, or `stem` with the first number from 2 that no solid and no block of the project is called by.
std::string free_name(const Project& project, const std::string& stem);

}  // namespace talus
