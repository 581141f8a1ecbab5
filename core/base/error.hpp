#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace talus {

/// Something in the input that the user can mend. Says where, what is wrong and what to do; the program prints
/// `file: place: problem; remedy` on one line and exits with code 2.
class InputError : public std::runtime_error {
 public:
  InputError(std::string place, std::string problem, std::string remedy)
      : std::runtime_error(place + ": " + problem + "; " + remedy),
        place_(std::move(place)),
        problem_(std::move(problem)),
        remedy_(std::move(remedy)) {}

  /// Line or JSON pointer in the file, or the name of the thing ("/materials/rock/density", "cut 3 (J2)").
  const std::string& place() const { return place_; }
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }

 private:
  std::string place_, problem_, remedy_;
};

}  // namespace talus
