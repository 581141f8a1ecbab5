#pragma once

#include <vector>

#include "render/scene/plane_section.hpp"

namespace talus {

/// What is drawn of a cut: its planes inside the rock.
struct JointFace {
  int cut = -1;                         ///< in the project's list
  int set = 0;                          ///< cuts of one joint have one colour
  std::vector<FlatTriangle> triangles;  ///< m
  std::vector<Edge> outline;            ///< m
};

}  // namespace talus
