#pragma once

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// The rules of what acts on blocks. Each throws InputError for the first rule that is broken.
void check(const Constraint& constraint, const Place& place);
void check(const PointLoad& load, const Place& place);
void check(const InitialVelocity& velocity, const Place& place);
void check(const InSituStress& in_situ, const Place& place);

}  // namespace talus
