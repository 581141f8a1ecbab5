#pragma once

#include <optional>
#include <span>

#include "render/scene/block_actors.hpp"

namespace talus {

/// Where a ray first meets the drawn surface.
struct RayHit {
  const BlockActors* part = nullptr;
  int triangle = -1;                ///< index into part->surface().triangles
  std::array<double, 3> weights{};  ///< of the triangle's vertices, sum 1
  Vec3 position = Vec3::Zero();
};

/// `direction` need not be a unit vector. Hits in front of `start` only.
std::optional<RayHit> first_hit(std::span<const BlockActors* const> parts, const Vec3& start, const Vec3& direction);

}  // namespace talus
