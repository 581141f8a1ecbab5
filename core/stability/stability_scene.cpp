#include "stability/stability_scene.hpp"

#include <algorithm>
#include <stdexcept>

namespace talus {

int Course::block(const std::string& name) const {
  const auto found =
      std::find_if(system.blocks.begin(), system.blocks.end(), [&](const Block& one) { return one.name == name; });
  if (found == system.blocks.end()) throw std::logic_error("the scene has no block '" + name + "'");
  return static_cast<int>(found - system.blocks.begin());
}

const Moment& Course::end_of_stage(int stage) const {
  const auto last =
      std::find_if(moments.rbegin(), moments.rend(), [stage](const Moment& moment) { return moment.stage == stage; });
  if (last == moments.rend()) throw std::logic_error("the run did not come to stage " + std::to_string(stage));
  return *last;
}

}  // namespace talus
