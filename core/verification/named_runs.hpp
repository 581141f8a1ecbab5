#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/part_of_progress.hpp"

/// What lists of runs have in common, be they known cases or hard cases: items that have a `name`.
namespace talus {

/// For what the user called by a name that none has; `kind`: "case".
template <typename Item>
InputError none_of_that_name(const std::string& kind, const std::string& name, const std::vector<Item>& items) {
  std::string known;
  for (const Item& one : items) (known += known.empty() ? "" : ", ") += one.name;
  return InputError(kind + " '" + name + "'", "there is none of that name", "choose among " + known);
}

/// "40 of 42 cases passed"; `kind`: "cases". A `Result` has passed().
template <typename Result>
std::string passed_text(const std::string& kind, const std::vector<Result>& results) {
  const auto passed = std::count_if(results.begin(), results.end(), [](const Result& one) { return one.passed(); });
  return std::to_string(passed) + " of " + std::to_string(results.size()) + ' ' + kind + " passed";
}

/// Calls run(item, progress) for one after the other; each has its share of the progress. Throws Cancelled when told
/// to.
template <typename Item, typename Run>
void run_in_turn(const std::vector<Item>& items, Progress& progress, const Run& run) {
  const double share = 1 / static_cast<double>(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (progress.cancelled()) throw Cancelled{};
    PartOfProgress part(progress, share * static_cast<double>(i), share, items[i].name);
    part.report(0, "");
    run(items[i], part);
  }
}

}  // namespace talus
