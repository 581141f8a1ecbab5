#pragma once

#include <vector>

#include "contact/narrow/grouped.hpp"
#include "contact/narrow/step_geometry.hpp"

namespace talus {

/// Vertices that were found on facets and make no contact there: what else holds a vertex, whichever body that is,
/// tells. Whoever holds a vertex must be known of all bodies.
class FalseVertices {
 public:
  void clear() { held_.clear(); }
  /// Points that stay where they are until drop().
  void add(const StepGeometry& step, FoundPoints& found);
  /// Drops those that are false.
  void drop(const StepGeometry& step);

 private:
  struct Held {
    int node;
    int body;           // that holds it
    FoundPoint* point;  // none: covered
    Vec3 normal;        // towards the node's body
  };
  void drop_doubled(const StepGeometry& step);
  bool past_sharp_edge(const StepGeometry& step, const Held& h) const;
  bool deeper(const StepGeometry& step, const Held& h) const;
  static bool pushes(const Held& held);

  Grouped<Held> held_;         // by node
  std::vector<Held> pushing_;  // sorted by node; in which order a node is pushed does not matter
};

}  // namespace talus
