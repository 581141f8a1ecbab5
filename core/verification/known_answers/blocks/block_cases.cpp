#include "verification/known_answers/blocks/block_cases.hpp"

#include <algorithm>
#include <iterator>

#include "verification/known_answers/blocks/column_row.hpp"
#include "verification/known_answers/blocks/dominoes.hpp"
#include "verification/known_answers/blocks/oscillation.hpp"
#include "verification/known_answers/blocks/slide_or_topple.hpp"

namespace talus {

std::vector<KnownCase> block_cases() {
  std::vector<KnownCase> all;
  for (auto& group : {sliding_cases(), slide_or_topple_cases(), column_row_cases(), arch_cases(), oscillation_cases(),
                      resting_cases(), rocking_cases(), bouncing_cases(), domino_cases()})
    std::transform(group.begin(), group.end(), std::back_inserter(all), at_any_scale);
  return all;
}

}  // namespace talus
