#pragma once

#include <string>
#include <vector>

#include "model/project.hpp"

namespace talus {

/// What is wrong with a project, or odd about it, as a compiler tells it.
struct ProjectProblem {
  enum class Kind {
    error,    ///< it cannot be run so
    warning,  ///< it can, and hardly is what was meant
    hint      ///< it may be so on purpose
  };
  Kind kind = Kind::error;
  std::string place;  ///< JSON pointer
  std::string problem, remedy;
  bool operator==(const ProjectProblem&) const = default;
};

/// All rules that `validate` holds and that are broken, at most one a place, then what is odd. Changes nothing, throws
/// nothing, and takes well under a millisecond for a hundred things.
std::vector<ProjectProblem> problems_of(const Project& project);

}  // namespace talus
