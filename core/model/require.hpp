#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/vector.hpp"
#include "model/place.hpp"

namespace talus {

/// While one lives on a thread, rules that are broken there do not throw: all of them are gathered, one a place, and
/// the checks go on. The window shows the list; a file that is read is refused for the first.
class BrokenRules {
 public:
  BrokenRules();
  ~BrokenRules();
  BrokenRules(const BrokenRules&) = delete;
  BrokenRules& operator=(const BrokenRules&) = delete;

  void add(const InputError& error);
  const std::vector<InputError>& all() const { return all_; }

 private:
  BrokenRules* before_;
  std::vector<InputError> all_;
};

/// For checks that read on only where the rules before hold: the first that is broken ends them, and counts.
void stop_at_first_broken(const std::function<void()>& check);

/// The building stones of `validate`: each throws InputError at `place` when its rule is broken.
void require(bool holds, const Place& place, const std::string& problem, const std::string& remedy);

void require_finite(double value, const Place& place);
void require_finite(const Vec3& value, const Place& place);

/// `unit` is put into the remedy: "give a positive number of kg/m³".
void require_positive(double value, const Place& place, const std::string& what, const std::string& unit);
void require_not_negative(double value, const Place& place, const std::string& what, const std::string& unit);

}  // namespace talus
