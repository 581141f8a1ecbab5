#pragma once

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// At least 0 and below 90 degrees, of a joint or of rock.
void check_friction_angle(double angle, const Place& place);

/// The rules of a joint's properties, at `place` in the project. Throws InputError for the first that is broken.
void check(const Joint& joint, const Place& place);

}  // namespace talus
