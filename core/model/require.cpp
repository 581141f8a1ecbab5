#include "model/require.hpp"

#include <cmath>

#include "base/error.hpp"
#include "model/number_text.hpp"

namespace talus {

void require(bool holds, const Place& place, const std::string& problem, const std::string& remedy) {
  if (!holds) throw InputError(place.text(), problem, remedy);
}

void require_finite(double value, const Place& place) {
  if (!std::isfinite(value)) throw InputError(place.text(), "is not a finite number", "give a finite number");
}

void require_finite(const Vec3& value, const Place& place) {
  for (int i = 0; i < 3; ++i) require_finite(value[i], place / static_cast<std::size_t>(i));
}

void require_positive(double value, const Place& place, const std::string& what, const std::string& unit) {
  require_finite(value, place);
  if (value > 0) return;
  throw InputError(place.text(), what + " must be greater than 0, is " + number_text(value),
                   "give a positive number of " + unit);
}

void require_not_negative(double value, const Place& place, const std::string& what, const std::string& unit) {
  require_finite(value, place);
  if (value >= 0) return;
  throw InputError(place.text(), what + " must not be negative, is " + number_text(value),
                   "give 0 or a positive number of " + unit);
}

}  // namespace talus
