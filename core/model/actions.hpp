#pragma once

#include <functional>

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// Calls `visit(place, constraint)` for those that hold from the start and for those that stages put in their place.
void for_each_constraint(const Project& project, const std::function<void(const Place&, const Constraint&)>& visit);

/// Calls `visit(place, load)` for those that act from the start and for those that stages put in their place.
void for_each_load(const Project& project, const std::function<void(const Place&, const PointLoad&)>& visit);

}  // namespace talus
