#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/block_scene.hpp"

namespace talus {

/// A block and fixed ones that meet it in a place where the direction of contact is not plain.
struct Meeting {
  std::string name, title;
  bool firm;  ///< a stable balance: a drop and a push of a fifth of the weight leave the block where it is
  std::function<void(CaseScene&)> add_bodies;  ///< the block is the last of them, as it touches
  Vec3 floor = Vec3::Zero();                   ///< a point of the plane that the block's centroid never passes
  Vec3 up = Vec3::UnitZ(), side = Vec3::UnitX();
  std::string block = "block";
};

std::vector<Meeting> meetings();

}  // namespace talus
