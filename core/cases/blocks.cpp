#include <algorithm>

#include "cases/all_cases.hpp"
#include "cases/arch.hpp"
#include "cases/block_scene.hpp"
#include "cases/column_row.hpp"
#include "cases/dominoes.hpp"
#include "cases/oscillation.hpp"
#include "cases/resting.hpp"
#include "cases/rocking.hpp"
#include "cases/slide_or_topple.hpp"
#include "cases/sliding.hpp"

namespace talus {

std::vector<KnownCase> block_cases() {
  std::vector<KnownCase> all;
  for (auto& group : {sliding_cases(), slide_or_topple_cases(), column_row_cases(), arch_cases(), oscillation_cases(),
                      resting_cases(), rocking_cases(), bouncing_cases(), domino_cases()})
    std::transform(group.begin(), group.end(), std::back_inserter(all), at_any_scale);
  return all;
}

}  // namespace talus
