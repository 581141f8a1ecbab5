#include "model/require.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/number_text.hpp"

namespace talus {

namespace {

thread_local BrokenRules* gathering = nullptr;

}  // namespace

BrokenRules::BrokenRules() : before_(std::exchange(gathering, this)) {}

BrokenRules::~BrokenRules() { gathering = before_; }

void BrokenRules::add(const InputError& error) {
  const auto same_place = [&](const InputError& other) { return other.place() == error.place(); };
  if (std::none_of(all_.begin(), all_.end(), same_place)) all_.push_back(error);
}

void stop_at_first_broken(const std::function<void()>& check) {
  BrokenRules* const gatherer = std::exchange(gathering, nullptr);
  if (!gatherer) return check();
  try {
    check();
  } catch (const InputError& error) {
    gatherer->add(error);
  }
  gathering = gatherer;
}

void require(bool holds, const Place& place, const std::string& problem, const std::string& remedy) {
  if (holds) return;
  const InputError error(place.text(), problem, remedy);
  if (!gathering) throw error;
  gathering->add(error);
}

void require_finite(double value, const Place& place) {
  require(std::isfinite(value), place, "is not a finite number", "give a finite number");
}

void require_finite(const Vec3& value, const Place& place) {
  for (int i = 0; i < 3; ++i) require_finite(value[i], place / static_cast<std::size_t>(i));
}

void require_positive(double value, const Place& place, const std::string& what, const std::string& unit) {
  require_finite(value, place);
  require(value > 0, place, what + " must be greater than 0, is " + number_text(value),
          "give a positive number of " + unit);
}

void require_not_negative(double value, const Place& place, const std::string& what, const std::string& unit) {
  require_finite(value, place);
  require(value >= 0, place, what + " must not be negative, is " + number_text(value),
          "give 0 or a positive number of " + unit);
}

}  // namespace talus
