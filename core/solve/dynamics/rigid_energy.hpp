#pragma once

#include <span>
#include <vector>

#include "bodies/body_set.hpp"

namespace talus {

/// What rigid bodies gain in a step beyond what loads give them: the kinetic energy at its end, less that at its start,
/// less the work of loads on their centroids. It is the work of contacts and impacts, which must not be above zero.
class RigidEnergy {
 public:
  /// `set` outlives it.
  explicit RigidEnergy(const BodySet& set) : set_(set) {}

  /// Bodies are as at the start of the step.
  void note_start();
  /// Bodies have moved, in a step of this length [s], and have the velocities that they would have had without contact.
  /// From now on it is asked of those rigid ones among `bodies` that are not fixed.
  void note_without_contact(std::span<const int> bodies, double length);
  double gain() const;     ///< J, with the velocities of now
  double kinetic() const;  ///< J, now

 private:
  struct Start {
    Vec3 position, velocity;  // m, m/s, of the centroid
    double kinetic;           // J
  };

  const BodySet& set_;
  std::vector<Start> starts_;  // a rigid body
  std::vector<int> asked_of_;  // rigid bodies
  double given_ = 0;           // J, what these had at the start and what loads gave them
};

}  // namespace talus
