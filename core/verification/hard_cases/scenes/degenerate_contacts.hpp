#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verification/known_answers/support/scene.hpp"

namespace talus {

/// A block and fixed ones that touch it where the direction of contact is ambiguous.
struct DegenerateContact {
  std::string name, title;
  bool stable;  ///< in stable equilibrium: a drop and a push of a fifth of the weight leave the block where it is
  std::function<void(CaseScene&)> add_bodies;  ///< the block is the last of them, as it touches
  Vec3 floor = Vec3::Zero();                   ///< a point of the plane that the block's centroid never passes
  Vec3 up = Vec3::UnitZ(), side = Vec3::UnitX();
  std::string block = "block";
};

std::vector<DegenerateContact> degenerate_contacts();

}  // namespace talus
