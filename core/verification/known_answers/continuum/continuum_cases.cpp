#include "verification/known_answers/continuum/continuum_cases.hpp"

#include <algorithm>
#include <iterator>

namespace talus {

std::vector<KnownCase> continuum_cases() {
  std::vector<KnownCase> all;
  for (auto& group : {free_fall_cases(), patch_test_cases(), beam_cases(), wave_cases(), spin_cases(), spring_cases(),
                      pinned_bar_cases(), crack_cases()})
    std::copy(group.begin(), group.end(), std::back_inserter(all));
  return all;
}

}  // namespace talus
