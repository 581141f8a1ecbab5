#include "verification/known_answers/known_cases.hpp"

#include <algorithm>
#include <iterator>

#include "verification/known_answers/blocks/block_cases.hpp"
#include "verification/known_answers/continuum/continuum_cases.hpp"
#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {

std::vector<KnownCase> known_cases() {
  std::vector<KnownCase> all;
  for (auto& group : {block_cases(), continuum_cases(), wedge_cases()})
    std::copy(group.begin(), group.end(), std::back_inserter(all));
  return all;
}

}  // namespace talus
