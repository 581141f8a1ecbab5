#include "cases/all_cases.hpp"

#include <algorithm>
#include <iterator>

namespace talus {

std::vector<KnownCase> known_cases() {
  std::vector<KnownCase> all;
  for (auto& group : {block_cases(), continuum_cases(), wedge_cases()})
    std::copy(group.begin(), group.end(), std::back_inserter(all));
  return all;
}

}  // namespace talus
