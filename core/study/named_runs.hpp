#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/part_of_progress.hpp"

/// What lists of runs have in common, be they known cases or scenes of stability: items that have a `name`.
namespace talus {

/// For what the user called by a name that none has; `kind`: "case".
template <typename Item>
InputError none_of_that_name(const std::string& kind, const std::string& name, const std::vector<Item>& items) {
  std::string known;
  for (const Item& one : items) (known += known.empty() ? "" : ", ") += one.name;
  return InputError(kind + " '" + name + "'", "there is none of that name", "choose among " + known);
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
