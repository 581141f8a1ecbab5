#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"
#include "mesh/cutting_report.hpp"

namespace talus {

/// The cuts leave splinters, and the project says that they are refused: where each of them is.
class SplintersFound : public InputError {
 public:
  SplintersFound(std::string place, std::string problem, std::string remedy, std::vector<Splinter> splinters)
      : InputError(std::move(place), std::move(problem), std::move(remedy)), splinters_(std::move(splinters)) {}

  const std::vector<Splinter>& splinters() const { return splinters_; }

 private:
  std::vector<Splinter> splinters_;
};

}  // namespace talus
