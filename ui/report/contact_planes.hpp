#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/project.hpp"
#include "orientation/attitude.hpp"

namespace talus {

struct BlockSystem;

}  // namespace talus

namespace talus::report {

/// A plane in which two blocks lie against each other before anything moves.
struct ContactPlane {
  std::string joint;
  std::array<std::string, 2> between;
  PlaneAttitude attitude;
  double area = 0;  ///< m²
};

/// All of them but those between fixed blocks, the largest first: the joints of blocks that no cut has made.
std::vector<ContactPlane> contact_planes(const BlockSystem& system, const Project& project);

}  // namespace talus::report
