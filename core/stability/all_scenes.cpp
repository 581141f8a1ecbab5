#include "stability/all_scenes.hpp"

#include <iterator>

namespace talus {

std::vector<StabilityScene> stability_scenes() {
  std::vector<StabilityScene> all;
  for (auto group : {degenerate_scenes, classic_scenes, ratio_scenes, odd_shape_scenes, time_scenes, crowd_scenes,
                     state_change_scenes, threshold_scenes}) {
    std::vector<StabilityScene> scenes = group();
    std::move(scenes.begin(), scenes.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace talus
