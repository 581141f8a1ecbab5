#pragma once

#include <string>

namespace talus {

/// What people type for a quantity, as a number in `kept`, the unit that the program keeps: "50 kPa" for "Pa" is 50000,
/// "0.5 rad" for "°" 28.65, "2,7 t/m³" for "kg/m³" 2700. A number alone is in `shown`, the unit that the field shows.
/// Units are products of powers: "kg/m³", "kN/m2", "m s^-2". A weight per volume stands for a density, under
/// `weight_gravity`. Throws InputError, whose problem and remedy say what measures what, for what is no number, no
/// known unit or one of something else.
double read_quantity(const std::string& text, const std::string& kept, const std::string& shown);

/// A number of the unit `from` in the unit `to`, which measure the same. Throws InputError where they do not.
double converted(double value, const std::string& from, const std::string& to);

/// m/s², between a density and the weight per volume that is typed or shown for it.
constexpr double weight_gravity = 9.81;

}  // namespace talus
