#pragma once

#include <string>

#include "base/vector.hpp"
#include "model/place.hpp"

namespace talus {

/// The building stones of `validate`: each throws InputError at `place` when its rule is broken.
void require(bool holds, const Place& place, const std::string& problem, const std::string& remedy);

void require_finite(double value, const Place& place);
void require_finite(const Vec3& value, const Place& place);

/// `unit` is put into the remedy: "give a positive number of kg/m³".
void require_positive(double value, const Place& place, const std::string& what, const std::string& unit);
void require_not_negative(double value, const Place& place, const std::string& what, const std::string& unit);

}  // namespace talus
