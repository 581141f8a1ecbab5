#pragma once

#include <stdexcept>
#include <string>

namespace talus {

/// The matrix has a direction without stiffness or mass: our own mistake, or numbers beyond reason in the input.
struct NotPositiveDefinite : std::runtime_error {
  explicit NotPositiveDefinite(int movable_node)
      : std::runtime_error("the stiffness matrix is not positive definite at node " + std::to_string(movable_node)),
        node(movable_node) {}
  int node;
};

}  // namespace talus
