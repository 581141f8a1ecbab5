#include "verification/hard_cases/scenes/all_hard_cases.hpp"

#include <iterator>

#include "verification/hard_cases/classic/classic_scenes.hpp"
#include "verification/hard_cases/scenes/scene_groups.hpp"

namespace talus {

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (auto group : {degenerate_scenes, classic_scenes, ratio_scenes, odd_shape_scenes, time_scenes, crowd_scenes,
                     jointed_slopes, state_change_scenes, threshold_scenes, found_scenes}) {
    std::vector<HardCase> scenes = group();
    std::move(scenes.begin(), scenes.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace talus
