#pragma once

#include <map>
#include <vector>

#include "base/disjoint_sets.hpp"

namespace talus {

/// The number of each thing's set, from 0 in the order of their first things.
inline std::vector<int> set_numbers(DisjointSets& sets) {
  std::map<int, int> number;
  std::vector<int> numbers;
  for (int thing = 0; thing < sets.size(); ++thing)
    numbers.push_back(number.try_emplace(sets.first_of(thing), static_cast<int>(number.size())).first->second);
  return numbers;
}

}  // namespace talus
