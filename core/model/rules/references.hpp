#pragma once

#include <functional>
#include <string>

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// Names that must be given once: materials, joints, solids and block overrides, stages, monitors.
void validate_names(const Project& project);

/// Materials, joints and solids that are used must be defined; blocks must be possible names.
void validate_references(const Project& project);

/// Contacts that lie on no cut must have a joint, where there may be such.
void validate_default_joint(const Project& project);

/// Calls `visit(place, name)` for every place where the project names a block. Expectations are among them unless
/// they name a monitor; their place is the quantity.
void for_each_block_reference(const Project& project,
                              const std::function<void(const Place&, const std::string&)>& visit);

}  // namespace talus
