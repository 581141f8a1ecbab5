#include <algorithm>

#include "cases/all_cases.hpp"
#include "cases/block_scene.hpp"
#include "cases/slide_or_topple.hpp"
#include "cases/sliding.hpp"

namespace talus {

std::vector<KnownCase> block_cases() {
  std::vector<KnownCase> all;
  for (auto& group : {sliding_cases(), slide_or_topple_cases()})
    std::transform(group.begin(), group.end(), std::back_inserter(all), at_any_scale);
  return all;
}

}  // namespace talus
