#pragma once

#include <span>
#include <vector>

#include "bodies/body_set.hpp"

namespace talus {

/// What bodies gain in a step beyond what loads and the stresses within them give them: the kinetic energy at its end,
/// less that at its start, less the work of those forces. It is the work of contacts and impacts, which must not be
/// above zero.
class EnergyGain {
 public:
  /// `set` outlives it.
  explicit EnergyGain(const BodySet& set) : set_(set) {}

  /// Bodies are as at the start of the step.
  void note_start();
  /// Bodies have moved, in a step of this length [s], and have the velocities that they would have had without contact.
  /// From now on it is asked of those among `bodies`, which outlive the step, that are not fixed.
  void note_without_contact(std::span<const int> bodies, double length);
  double gain() const;     ///< J, with the velocities of now
  double kinetic() const;  ///< J, now

 private:
  Vec3 change_of_velocity(int node) const { return set_.nodes.velocity[node] - velocity_[node]; }
  Vec3 way(int node) const { return set_.nodes.position[node] - position_[node]; }
  /// What other forces than those of contact do, times the length of the step [J s].
  double work_on(const RigidBody& body) const;
  double work_on(const Element& element) const;

  const BodySet& set_;
  std::vector<Vec3> position_, velocity_;  // m, m/s, of each node at the start
  std::vector<double> kinetic_;            // J, of each body at the start
  std::span<const int> asked_of_;          // bodies
  double given_ = 0;                       // J, what these had at the start and what other forces gave them
};

}  // namespace talus
