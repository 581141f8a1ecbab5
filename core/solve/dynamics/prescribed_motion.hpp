#pragma once

#include "bodies/body_set.hpp"

namespace talus {

/// Fixed blocks that move as a whole by a constraint without a point: a shaking base.
class PrescribedMotion {
 public:
  /// `project` as it holds in the stage.
  PrescribedMotion(const Project& project, const BlockSystem& system);

  /// Sets the increments of the blocks' nodes so that they stand where they are wanted at `end` [s].
  void begin_step(BodySet& bodies, double end) const;
  /// Sets them to none.
  void stand_still(BodySet& bodies) const;

 private:
  struct Moved {
    int body;
    Constraint constraint;
  };
  std::vector<Moved> moved_;
};

}  // namespace talus
