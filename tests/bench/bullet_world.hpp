#pragma once

#include <memory>

#include "mesh/block.hpp"

namespace talus {

/// The same blocks in Bullet's world (bulletphysics.org), as games use it: convex hulls, sequential impulses with the
/// usual ten iterations, single precision or double as the library was built.
class BulletWorld {
 public:
  /// Blocks at rest; fixed ones stay. Friction is that of the project's first joint, restitution 0. `sleeps`: bodies at
  /// rest may be deactivated.
  BulletWorld(const Project& project, const BlockSystem& system, bool sleeps);
  ~BulletWorld();
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  /// One step [s], not divided.
  void step(double length);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace talus
